// SPDX-License-Identifier: GPL-2.0-or-later
// Derivatives of the dynamics of robots with a floating base: columns of the base in its tangent space, against slopes
// along real motions, and mistakes in them against the proof.
#include <gtest/gtest.h>

#include "flatdyn/reference/derivatives.hpp"
#include "functions/exact_proof.hpp"
#include "functions/planning/formulations.hpp"
#include "robot/model/states.hpp"
#include "support/floating_robots.hpp"
#include "support/mutants.hpp"
#include "support/written_model.hpp"
#include "truth/reference/graph_evaluator.hpp"
#include "truth/reference/reference_model.hpp"

namespace flatdyn {
namespace {

namespace ref = reference;
using Vector50 = ref::VectorX<Real50>;
using Matrix50 = ref::MatrixX<Real50>;
using Axis50 = ref::Vector3<Real50>;

const Real50 kSmallStep("1e-12");
constexpr Eigen::Index kTurn = 3, kBase = 6;

class FloatingDerivatives : public ::testing::Test {
 protected:
  FloatingDerivatives() : robot_(reference_robot<Real50>(model_.robot, {})) {
    const StateOf<Real50> wide = widened<Real50>(state_);
    q_ = vector_of(wide.q), v_ = vector_of(wide.qd), a_ = vector_of(wide.qdd), tau_ = vector_of(wide.tau);
    robot_.gravity = vector_of(wide.g_b);
  }

  // The central difference of a function of a step.
  template <class Values>
  static Vector50 slope(const Values& values) {
    return (values(kSmallStep) - values(-kSmallStep)) / (2 * kSmallStep);
  }

  static void expect_near(const Vector50& found, const Vector50& right, const std::string& what) {
    EXPECT_LT(Real50((found - right).norm() / (1 + right.norm())).convert_to<double>(), 1e-18) << what;
  }

  LoadedRobot model_ = testing::model_of_toml(testing::kSatellite);
  const State state_ = random_states(model_.mechanism, 1, 5).front();
  ref::Robot<Real50> robot_;
  Vector50 q_, v_, a_, tau_;
};

// R ← R exp(S(δ)) turns g_b = Rᵀ g_0; v, a and τ stay as numbers in base axes.
TEST_F(FloatingDerivatives, TurnTheBaseAboutItsAxes) {
  const auto R = ref::rotation_about<Real50>(Axis50(Real50(2) / 7, Real50(3) / 7, Real50(6) / 7), Real50("0.8"));
  const Axis50 g_0(0, 0, Real50("-9.81"));
  robot_.gravity = R.transpose() * g_0;
  const ref::Derivatives<Real50> torques = ref::inverse_dynamics_derivatives(robot_, q_, v_, a_);
  const ref::AccelerationDerivatives<Real50> accelerations = ref::forward_dynamics_derivatives(robot_, q_, v_, tau_);
  for (Eigen::Index j = 0; j < 3; ++j) {
    const auto turned = [&](const Real50& angle) {
      ref::Robot<Real50> robot = robot_;
      const ref::Matrix3<Real50> later = R * ref::rotation_about<Real50>(Axis50::Unit(j), angle);
      robot.gravity = later.transpose() * g_0;
      return robot;
    };
    expect_near(torques.dq.col(kTurn + j),
                slope([&](const Real50& h) { return ref::inverse_dynamics(turned(h), q_, v_, a_); }), "tau");
    expect_near(accelerations.dq.col(kTurn + j),
                slope([&](const Real50& h) { return ref::forward_dynamics(turned(h), q_, v_, tau_); }), "a");
  }
}

TEST_F(FloatingDerivatives, AreSlopesOfAccelerations) {
  const ref::AccelerationDerivatives<Real50> found = ref::forward_dynamics_derivatives(robot_, q_, v_, tau_);
  const auto step = [](const Vector50& x, Eigen::Index k, const Real50& h) {
    return Vector50(x + h * Vector50::Unit(x.size(), k));
  };
  for (Eigen::Index k = 0; k < v_.size(); ++k) {
    const auto by_v = [&](const Real50& h) { return ref::forward_dynamics(robot_, q_, step(v_, k, h), tau_); };
    const auto by_tau = [&](const Real50& h) { return ref::forward_dynamics(robot_, q_, v_, step(tau_, k, h)); };
    expect_near(found.dqd.col(k), slope(by_v), "v");
    expect_near(found.dtau.col(k), slope(by_tau), "tau");
  }
  for (Eigen::Index k = 0; k < q_.size(); ++k) {
    const auto by_q = [&](const Real50& h) { return ref::forward_dynamics(robot_, step(q_, k, h), v_, tau_); };
    expect_near(found.dq.col(kBase + k), slope(by_q), "q");
  }
}

// All parts fall alike, and a uniform motion is not felt: turns of the base and its velocity change v̇ alone, and the
// code has zeros for the rest.
TEST_F(FloatingDerivatives, ShowThatAllPartsFallAlike) {
  const Function function = derive_function(model_.mechanism, "forward_dynamics_derivatives");
  ASSERT_EQ(function.outputs[0].name, "da_dq");
  ASSERT_EQ(function.outputs[1].name, "da_dv");
  GraphEvaluator<double> graph(function);
  const auto values = graph(state_);
  ASSERT_TRUE(values);
  const auto n = static_cast<std::size_t>(model_.mechanism.size());
  const auto is_zero = [&function](const Output& output, std::size_t entry) {
    return function.graph.is_zero(output.entries[entry]);
  };
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t shifted = i * n + j, turned = shifted + 3;
      EXPECT_TRUE(is_zero(function.outputs[0], shifted)) << i << " " << j;
      EXPECT_EQ(is_zero(function.outputs[0], turned), i == j || i >= 3) << i << " " << j;
      EXPECT_EQ(is_zero(function.outputs[1], shifted), i == j || i >= 3) << i << " " << j;
    }
  }
  EXPECT_EQ((*values)[3], 0);
  EXPECT_EQ((*values)[4], -state_.g_b[2]);        // of v̇_x by a turn about y: g_b × e_y
  EXPECT_EQ((*values)[n * n + 1], state_.qd[5]);  // of v̇_x by v_y: -ω × e_y
}

// A sign flipped at every sum of the drone's derivatives.
TEST(FloatingDerivativesProof, CatchesEveryMutant) {
  const Mechanism mechanism = testing::model_of_toml(testing::kDrone).mechanism;
  ExactOptions quick;
  quick.points = 1;
  int mutants = 0;
  for (const char* name : {"inverse_dynamics_derivatives", "forward_dynamics_derivatives"}) {
    Function function = derive_function(mechanism, name);
    std::vector<NodeId> entries;
    for (const Output& output : function.outputs) {
      entries.insert(entries.end(), output.entries.begin(), output.entries.end());
    }
    const std::vector<bool> alive = reachable_from(function.graph, entries);
    for (NodeId id = 0; id < function.graph.size(); ++id) {
      if (!alive[static_cast<std::size_t>(id)] || function.graph[id].op != Op::sum) continue;
      const Function wrong = testing::mutant(function, id, testing::MutantKind::flip_sign);
      EXPECT_FALSE(prove_exactly(mechanism, wrong, quick).equal) << name << " " << id;
      ++mutants;
    }
  }
  EXPECT_GT(mutants, 100);
}

}  // namespace
}  // namespace flatdyn
