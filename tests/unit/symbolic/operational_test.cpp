// SPDX-License-Identifier: GPL-2.0-or-later
// The operational space's functions against what the textbook says of them, in 50 digits.
#include "symbolic/operational.hpp"

#include <gtest/gtest.h>

#include "flatdyn/reference/operational.hpp"
#include "support/robot_models.hpp"
#include "symbolic/formulations.hpp"
#include "verify/values.hpp"

namespace flatdyn {
namespace {

using reference::MatrixX;
using reference::VectorX;
using testing::model_of;

using Vector50 = VectorX<Real50>;
using Matrix50 = MatrixX<Real50>;

const Real50 kExact("1e-35");
const Real50 kDifferenced("1e-30");

class OperationalSpaceOf {
 public:
  OperationalSpaceOf(const std::string& robot, std::vector<int> task) : model_(model_of(robot)) {
    model_.mechanism.task = std::move(task);
    arm = reference_robot<Real50>(model_.robot, {});
    rows = task_rows(model_.mechanism);
    state = widened<Real50>(random_states(model_.mechanism, 1, 7).front());
  }

  int joints() const { return model_.mechanism.size(); }
  Vector50 q() const { return vector_of<Real50>(state.q); }
  Vector50 qd() const { return vector_of<Real50>(state.qd); }

  // All outputs of a function at a state, one after the other.
  Vector50 values(const std::string& function, const StateOf<Real50>& at) const {
    const Function derived = derive_function(model_.mechanism, function);
    const auto result = GraphEvaluator<Real50>(derived)(at);
    EXPECT_TRUE(result.has_value()) << function;
    return vector_of<Real50>(*result);
  }
  // B_A, r × r, at a position.
  Matrix50 inertia(const Vector50& position) const {
    StateOf<Real50> at = state;
    at.q.assign(position.begin(), position.end());
    const auto r = static_cast<Eigen::Index>(rows.size());
    return values("operational_inertia", at).head(r * r).reshaped(r, r);
  }

  reference::Robot<Real50> arm;
  std::vector<int> rows;
  StateOf<Real50> state;

 private:
  Model model_;
};

TEST(Operational, ChoosesTheRowsThatAreIndependent) {
  const auto rows = [](const char* robot) { return task_rows(model_of(robot).mechanism); };
  EXPECT_EQ(rows("planar_2r.toml"), (std::vector{0, 1}));
  EXPECT_EQ(rows("cartesian_2.toml"), (std::vector{0, 2}));
  EXPECT_EQ(rows("scara.toml"), (std::vector{0, 1, 2, 5}));
  EXPECT_EQ(rows("panda.urdf"), (std::vector{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(task_text(rows("scara.toml")), "x, y, z, rz");
}

TEST(Operational, RefusesATaskThatTheTipCannotDo) {
  Mechanism arm = model_of("planar_2r.toml").mechanism;
  arm.task = {0, 2};
  EXPECT_THROW(task_rows(arm), Failure);
  arm.task = {1, 5};
  EXPECT_EQ(task_rows(arm), arm.task);
  EXPECT_THROW(derive_function(arm, "null_space_torque"), Failure);
}

// Problem 7.10: dB_A/dt - 2 C_A is skew-symmetric; for the velocities of a motion, ẋᵀ (½ dB_A/dt ẋ - C_A ẋ) = 0.
TEST(Operational, InertiaChangesByTwiceTheCoriolisMatrix) {
  for (const char* robot : {"planar_2r_example_7_2.toml", "puma560.toml"}) {
    const OperationalSpaceOf space(robot, {});
    ASSERT_EQ(static_cast<int>(space.rows.size()), space.joints());
    const Real50 step("1e-18");
    const Matrix50 change =
        (space.inertia(space.q() + step * space.qd()) - space.inertia(space.q() - step * space.qd())) / (2 * step);
    const Vector50 xd = Matrix50(reference::jacobian(space.arm, space.q())(space.rows, Eigen::all)) * space.qd();
    const auto r = static_cast<Eigen::Index>(space.rows.size());
    const Vector50 c_A = space.values("operational_bias", space.state).head(r);
    const Real50 power = xd.dot(change * xd) / 2;
    EXPECT_LE(Real50(abs(power - xd.dot(c_A))), kDifferenced * (1 + abs(power))) << robot;
    EXPECT_GT(Real50(abs(power)), Real50("1e-3")) << robot;
  }
}

// (7.133), (7.140), (7.141): whatever else drives the joints, τ = Jᵀ γ + (1 - Jᵀ J̄ᵀ) τ_0 gives the tip the
// acceleration B_A^-1 (γ - C_A ẋ - g_A); friction apart, which is no part of the model in the operational space.
TEST(Operational, SpareTorquesDoNotMoveTheTip) {
  OperationalSpaceOf space("panda.urdf", {0, 1, 2});
  const Eigen::Index n = space.joints(), r = 3;
  for (auto& joint : space.arm.joints) joint.viscous = joint.coulomb = Real50(0);
  const Matrix50 J = reference::jacobian(space.arm, space.q())(space.rows, Eigen::all);
  const Vector50 inertia = space.values("operational_inertia", space.state);
  const Matrix50 B_A = inertia.head(r * r).reshaped(r, r), J_bar = inertia.tail(n * r).reshaped(r, n).transpose();
  EXPECT_LE((J * J_bar - Matrix50::Identity(r, r)).cwiseAbs().maxCoeff(), kExact);
  const Vector50 bias = space.values("operational_bias", space.state);
  const Vector50 gamma = Vector50::LinSpaced(r, Real50(-20), Real50(35));
  const Vector50 wanted = B_A.inverse() * (gamma - bias.head(r) - bias.tail(r));
  for (const int scale : {0, 1, 10}) {
    StateOf<Real50> state = space.state;
    for (Real50& torque : state.tau) torque *= scale;
    const Vector50 spare = space.values("null_space_torque", state);
    EXPECT_EQ(spare.norm() > Real50(1), scale > 0) << scale;
    const Vector50 tau = J.transpose() * gamma + spare;
    const Vector50 qdd = reference::forward_dynamics(space.arm, space.q(), space.qd(), tau);
    const Vector50 drift = reference::jacobian_dot_qd(space.arm, space.q(), space.qd())(space.rows);
    EXPECT_LE((J * qdd + drift - wanted).cwiseAbs().maxCoeff(), kExact * (1 + wanted.norm())) << scale;
  }
}

}  // namespace
}  // namespace flatdyn
