// SPDX-License-Identifier: GPL-2.0-or-later
// The functions of the operational space against the textbook's statements on them, in 50 digits.
#include "derivation/dynamics/operational.hpp"

#include <gtest/gtest.h>

#include "derivation/dynamics/task_rows.hpp"
#include "flatdyn/reference/operational.hpp"
#include "functions/exact_proof.hpp"
#include "functions/planning/formulations.hpp"
#include "support/robot_models.hpp"
#include "support/written_model.hpp"
#include "truth/reference/graph_evaluator.hpp"
#include "truth/reference/operational_values.hpp"

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
  OperationalSpaceOf(LoadedRobot model, Task wanted) : model_(std::move(model)) {
    model_.mechanism.task = std::move(wanted);
    arm = reference_robot<Real50>(model_.robot, {});
    rows = task_rows(model_.mechanism);
    task = reference_task<Real50>({rows, model_.mechanism.task.orientation, model_.mechanism.task.damping});
    state = widened<Real50>(random_states(model_.mechanism, 1, 7).front());
  }

  int joints() const { return model_.mechanism.size(); }
  Vector50 q() const { return vector_of<Real50>(state.q); }
  Vector50 qd() const { return vector_of<Real50>(state.qd); }

  Function derived(const std::string& function) const { return derive_function(model_.mechanism, function); }
  const Mechanism& mechanism() const { return model_.mechanism; }

  // All outputs of a function at a state, one after the other; none where it has no value.
  std::optional<std::vector<Real50>> result(const std::string& function, const StateOf<Real50>& where) const {
    const Function made = derived(function);
    return GraphEvaluator<Real50>(made)(where);
  }
  Vector50 values(const std::string& function, const StateOf<Real50>& where) const {
    const auto found = result(function, where);
    EXPECT_TRUE(found.has_value()) << function;
    return vector_of<Real50>(found.value_or(std::vector<Real50>()));
  }
  StateOf<Real50> at(const Vector50& position) const {
    StateOf<Real50> moved = state;
    moved.q.assign(position.begin(), position.end());
    return moved;
  }
  // B_A, r × r, at a position.
  Matrix50 inertia(const Vector50& position) const {
    const auto r = static_cast<Eigen::Index>(rows.size());
    return values("operational_inertia", at(position)).head(r * r).reshaped(r, r);
  }

  reference::Robot<Real50> arm;
  std::vector<int> rows;
  reference::Task<Real50> task;
  StateOf<Real50> state;

 private:
  LoadedRobot model_;
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
  arm.task.rows = {0, 2};
  EXPECT_THROW(task_rows(arm), Failure);
  arm.task.rows = {1, 5};
  EXPECT_EQ(task_rows(arm), arm.task.rows);
  EXPECT_THROW(derive_function(arm, "null_space_torque"), Failure);
}

// Problem 7.10: dB_A/dt - 2 C_A is skew-symmetric. For the velocities of a motion, ẋᵀ (½ dB_A/dt ẋ - C_A ẋ) = 0, in
// Euler angles, too.
TEST(Operational, InertiaChangesByTwiceTheCoriolisMatrix) {
  const std::vector<std::pair<const char*, Orientation>> spaces = {
      {"planar_2r_example_7_2.toml", Orientation::angular_velocity},
      {"puma560.toml", Orientation::angular_velocity},
      {"puma560.toml", Orientation::zyz},
      {"puma560.toml", Orientation::rpy}};
  for (const auto& [robot, orientation] : spaces) {
    const OperationalSpaceOf space(model_of(robot), {{}, orientation});
    ASSERT_EQ(static_cast<int>(space.rows.size()), space.joints());
    const Real50 step("1e-18");
    const Matrix50 change =
        (space.inertia(space.q() + step * space.qd()) - space.inertia(space.q() - step * space.qd())) / (2 * step);
    const Vector50 xd = reference::task_jacobian(space.arm, space.q(), space.task) * space.qd();
    const auto r = static_cast<Eigen::Index>(space.rows.size());
    const Vector50 c_A = space.values("operational_bias", space.state).head(r);
    const Real50 power = xd.dot(change * xd) / 2;
    EXPECT_LE(Real50(abs(power - xd.dot(c_A))), kDifferenced * (1 + abs(power))) << robot;
    EXPECT_GT(Real50(abs(power)), Real50("1e-3")) << robot;
  }
}

// (7.133), (7.140), (7.141): whatever τ_0 drives the joints, τ = Jᵀ γ + (1 - Jᵀ J̄ᵀ) τ_0 gives the tip the acceleration
// B_A^-1 (γ - C_A ẋ - g_A), without friction, which is not part of the operational space's model.
TEST(Operational, SpareTorquesDoNotMoveTheTip) {
  for (const Task& task : {Task{{0, 1, 2}}, Task{{0, 2, 4}, Orientation::zyz}, Task{{3, 4, 5}, Orientation::rpy}}) {
    OperationalSpaceOf space(model_of("panda.urdf"), task);
    const Eigen::Index n = space.joints(), r = 3;
    for (auto& joint : space.arm.joints) joint.viscous = joint.coulomb = Real50(0);
    const Matrix50 J = reference::task_jacobian(space.arm, space.q(), space.task);
    const Vector50 inertia = space.values("operational_inertia", space.state);
    const Matrix50 B_A = inertia.head(r * r).reshaped(r, r),
                   J_bar = inertia.segment(r * r, n * r).reshaped(r, n).transpose();
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
      const Vector50 drift = reference::task_drift(space.arm, space.q(), space.qd(), space.task);
      EXPECT_LE((J * qdd + drift - wanted).cwiseAbs().maxCoeff(), kExact * (1 + wanted.norm())) << scale;
    }
  }
}

// The reference's rates are those of the angles that it takes from R, and its drift is their change.
TEST(Operational, TheReferenceDifferentiatesTheAngles) {
  const Real50 step("1e-18");
  for (const Orientation orientation : {Orientation::zyz, Orientation::rpy}) {
    const OperationalSpaceOf space(model_of("ur5.urdf"), {{3, 4, 5}, orientation});
    const auto moved = [&](int sign) { return Vector50(space.q() + sign * step * space.qd()); };
    const auto angles = [&](int sign) {
      return reference::euler_angles(reference::tip_pose(space.arm, moved(sign)).R, space.task.angles);
    };
    const auto rates = [&](int sign) {
      return Vector50(reference::task_jacobian(space.arm, moved(sign), space.task) * space.qd());
    };
    const Vector50 by_angles = (angles(1) - angles(-1)) / (2 * step), by_rates = (rates(1) - rates(-1)) / (2 * step);
    const Vector50 drift = reference::task_drift(space.arm, space.q(), space.qd(), space.task);
    EXPECT_LE((by_angles - rates(0)).cwiseAbs().maxCoeff(), kDifferenced * (1 + by_angles.norm()));
    EXPECT_LE((by_rates - drift).cwiseAbs().maxCoeff(), kDifferenced * (1 + drift.norm()));
    EXPECT_GT(drift.norm(), Real50("1e-3"));
  }
}

TEST(Operational, IsProvenInAnglesAndWithDamping) {
  for (const Task& task : {Task{{}, Orientation::zyz}, Task{{1, 4}, Orientation::rpy, Rational(1, 10)}}) {
    const OperationalSpaceOf space(model_of("puma560.toml"), task);
    for (const char* name : {"operational_inertia", "operational_bias", "null_space_torque"}) {
      if (task.empty() && name == std::string("null_space_torque")) continue;
      const Function function = space.derived(name);
      const ExactResult proof = prove_exactly(space.mechanism(), function);
      EXPECT_TRUE(proof.equal) << name << ": " << proof.summary();
      EXPECT_LT(proof.failure_log2, -100) << name;
      Function other = function;
      other.task.orientation = task.orientation == Orientation::zyz ? Orientation::rpy : Orientation::zyz;
      EXPECT_FALSE(prove_exactly(space.mechanism(), other).equal) << name;
      other = function;
      other.task.damping += Rational(1, 1000);
      EXPECT_FALSE(prove_exactly(space.mechanism(), other).equal) << name;
    }
  }
}

// A wrist whose joints are the angles roll, pitch and yaw.
constexpr const char* kWrist = R"toml(name = "wrist"
[[link]]
mass = 1
inertia = { xx = 0.1, yy = 0.2, zz = 0.3 }
inertia_about = "com"
[[link]]
axis = [0, 1, 0]
mass = 1
com = [0.1, 0, 0]
inertia = { xx = 0.2, yy = 0.1, zz = 0.1 }
inertia_about = "com"
[[link]]
axis = [1, 0, 0]
mass = 2
com = [0.2, 0.1, 0.05]
inertia = { xx = 0.05, yy = 0.1, zz = 0.15, xy = 0.01 }
inertia_about = "com"
)toml";

TEST(Operational, OfAWristInItsOwnAnglesIsTheJointSpace) {
  const OperationalSpaceOf space(testing::model_of_toml(kWrist), {{3, 4, 5}, Orientation::rpy});
  const Vector50 q = Vector50::LinSpaced(3, Real50("0.3"), Real50("0.9"));
  const StateOf<Real50> state = space.at(q);
  EXPECT_LE((space.inertia(q) - reference::inertia_matrix(space.arm, q)).cwiseAbs().maxCoeff(), kExact);
  const Vector50 zero = Vector50::Zero(3);
  const Vector50 c = reference::inverse_dynamics(space.arm, q, space.qd(), zero, {.gravity = false, .friction = false});
  const Vector50 bias = space.values("operational_bias", state);
  EXPECT_LE((bias.head(3) - c).cwiseAbs().maxCoeff(), kExact * (1 + c.norm()));
  EXPECT_LE((bias.tail(3) - reference::gravity(space.arm, q)).cwiseAbs().maxCoeff(), kExact);
  EXPECT_GT(c.norm(), Real50("1e-3"));
}

// The condition measure of J B^-1 Jᵀ lies between the ratio of its smallest to its largest eigenvalue and r² times
// that.
void expect_condition(const OperationalSpaceOf& space, const Vector50& q, const Real50& at_most) {
  const auto of = reference::operational_space(space.arm, q, space.task);
  const Eigen::MatrixXd B_A = of.B_A.cast<double>();
  const Eigen::VectorXd sizes = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(B_A).eigenvalues();
  const double ratio = sizes.minCoeff() / sizes.maxCoeff(), squared = static_cast<double>(B_A.rows() * B_A.rows());
  const Vector50 values = space.values("operational_inertia", space.at(q));
  const auto condition = static_cast<double>(values[values.size() - 1]);
  constexpr double kOfDoubles = 0.02;  // relative error, in double, of the smallest eigenvalue near a singularity
  EXPECT_GE(condition, ratio * (1 - kOfDoubles));
  EXPECT_LE(condition, ratio * squared * (1 + kOfDoubles));
  EXPECT_LE(Real50(condition), at_most);
}

TEST(Operational, TellsOfAStretchedArm) {
  const OperationalSpaceOf space(model_of("planar_2r_example_7_2.toml"), {});
  const OperationalSpaceOf damped(model_of("planar_2r_example_7_2.toml"),
                                  {{}, Orientation::angular_velocity, Rational(1, 100)});
  const auto bent_by = [](const char* angle) { return Vector50{{Real50("0.4"), Real50(angle)}}; };
  expect_condition(space, bent_by("1.5"), Real50(1));
  expect_condition(space, bent_by("1e-3"), Real50("1e-5"));
  expect_condition(space, bent_by("1e-6"), Real50("1e-11"));
  EXPECT_FALSE(space.result("operational_inertia", space.at(bent_by("0"))).has_value());

  // B_A is at most as stiff as 1 / λ², and almost undamped far from there.
  const Matrix50 B_A = damped.inertia(bent_by("0"));
  EXPECT_LE(B_A.trace(), Real50(2) * 10000);
  EXPECT_GT(B_A.trace(), Real50(9000));
  expect_condition(damped, bent_by("0"), Real50("0.1"));
  const Matrix50 bent = space.inertia(bent_by("1.5"));
  EXPECT_LE((damped.inertia(bent_by("1.5")) - bent).norm(), bent.norm() * bent.norm() / 10000);
}

// In ZYZ angles, with the wrist's x axis level, the angles' rates grow beyond all bounds, its inertia does not.
TEST(Operational, TellsOfAnglesThatAreSingular) {
  const OperationalSpaceOf space(testing::model_of_toml(kWrist), {{3, 4, 5}, Orientation::zyz});
  const auto tilted_by = [](const char* angle) { return Vector50{{Real50("0.2"), Real50(angle), Real50(0)}}; };
  expect_condition(space, tilted_by("1"), Real50(1));
  expect_condition(space, tilted_by("1e-3"), Real50("1e-4"));
  expect_condition(space, tilted_by("1e-6"), Real50("1e-10"));
  EXPECT_FALSE(space.result("operational_inertia", space.at(tilted_by("0"))).has_value());
}

TEST(Operational, RefusesAnglesThatAreSingularEverywhere) {
  Mechanism scara = model_of("scara.toml").mechanism;
  scara.task.orientation = Orientation::zyz;
  EXPECT_THROW(task_rows(scara), Failure);
  scara.task.orientation = Orientation::rpy;
  EXPECT_EQ(task_rows(scara), (std::vector{0, 1, 2, 3}));
  EXPECT_EQ(task_text(task_rows(scara), Orientation::rpy), "x, y, z, phi");
}

}  // namespace
}  // namespace flatdyn
