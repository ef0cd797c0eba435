// SPDX-License-Identifier: GPL-2.0-or-later
// A robot with a held joint equals the robot with that joint fixed in place: axes in any direction, all types.
#include <gtest/gtest.h>

#include "functions/planning/formulations.hpp"
#include "support/robots.hpp"
#include "truth/reference/dynamics_references.hpp"
#include "truth/reference/graph_evaluator.hpp"

namespace flatdyn {
namespace {

class HeldJoint : public ::testing::TestWithParam<unsigned> {
 protected:
  HeldJoint() {
    for (Joint& joint : robot_.joints) joint.motor.reset();
  }

  Robot held(int joint, const Number& position) const {
    Robot result = robot_;
    Joint& each = result.joints[static_cast<std::size_t>(joint)];
    each.held = Held{each.type, position};
    each.type = JointType::fixed;
    return result;
  }

  static std::vector<Real50> torques(const Robot& robot, const StateOf<Real50>& state) {
    const Function function = derive_function(make_mechanism(robot), "inverse_dynamics");
    return GraphEvaluator<Real50>(function)(state).value();
  }

  static void expect_equal(const std::vector<Real50>& a, const std::vector<Real50>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) EXPECT_LT(abs(a[k] - b[k]), Real50("1e-34") * (1 + abs(b[k])));
  }

  Robot robot_ = testing::random_tree(GetParam(), 5);
};

TEST_P(HeldJoint, IsWhereItIsHeld) {
  const std::vector<int> moving = moving_joints(robot_);
  const State drawn = random_states(make_mechanism(robot_), 1, GetParam()).at(0);
  for (std::size_t i = 0; i < moving.size(); ++i) {
    for (const Number& position : {Number(GiNaC::Pi / 6), Number(-3) / 7, Number(0)}) {
      StateOf<Real50> state = widened<Real50>(drawn);
      state.q[i] = Real50(to_decimal(position, 49));
      state.qd[i] = state.qdd[i] = 0;
      std::vector<Real50> expected = torques(robot_, state);
      const auto at = static_cast<std::ptrdiff_t>(i);
      for (auto* each : {&expected, &state.q, &state.qd, &state.qdd}) each->erase(each->begin() + at);
      const Robot still = held(moving[i], position);
      expect_equal(torques(still, state), expected);
      const auto reference = reference_robot<Real50>(still, {});
      const Mechanism mechanism = make_mechanism(still);
      const Function function = derive_function(mechanism, "inverse_dynamics");
      expect_equal(references::inverse_dynamics.exact({mechanism, reference, {}}, function)(state), expected);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(RandomTrees, HeldJoint, ::testing::Values(1U, 2U, 3U));

}  // namespace
}  // namespace flatdyn
