// SPDX-License-Identifier: GPL-2.0-or-later
// The proven bound of how far torques of two robots differ, against the reference at random motions within the limits.
#include "proof/verify/torque_difference.hpp"

#include <gtest/gtest.h>

#include "flatdyn/reference/newton_euler.hpp"
#include "robot/model/states.hpp"
#include "support/robot_models.hpp"

namespace flatdyn {
namespace {

using Robot50 = reference::Robot<Real50>;
using Vector50 = reference::VectorX<Real50>;

constexpr double kShift = 1e-6;

// Turns and shifts every number of the robot a little.
Robot50 shaken(Robot50 robot) {
  reference::Vector3<Real50> direction(1, -2, 2);
  direction /= 3;
  const reference::Matrix3<Real50> turned = reference::rotation_about<Real50>(direction, kShift);
  robot.gravity = turned * robot.gravity;
  for (auto& joint : robot.joints) {
    joint.R_0 = joint.R_0 * turned;
    joint.R_1 = turned * joint.R_1;
    joint.p_0 += kShift * direction;
    joint.p_1 += kShift * direction;
    if (joint.index >= 0) joint.axis = (turned * joint.axis).normalized();
    joint.rotor.axis = turned * joint.rotor.axis;
  }
  for (auto& link : robot.links) {
    for (auto& body : link.inertials) {
      body.r_C += kShift * direction;
      body.inertia(0, 1) += kShift;
      body.inertia(1, 0) += kShift;
    }
  }
  return robot;
}

double largest_difference(const Robot50& a, const Robot50& b, const std::vector<State>& states) {
  double largest = 0;
  for (const State& state : states) {
    const StateOf<Real50> wide = widened<Real50>(state);
    const auto torques = [&](const Robot50& robot) {
      return Vector50(reference::inverse_dynamics(robot, vector_of(wide.q), vector_of(wide.qd), vector_of(wide.qdd)));
    };
    largest = std::max(largest, (torques(a) - torques(b)).cwiseAbs().maxCoeff().convert_to<double>());
  }
  return largest;
}

class DifferenceOfTorques : public ::testing::TestWithParam<const char*> {};

TEST_P(DifferenceOfTorques, IsBelowItsBound) {
  const LoadedRobot model = testing::model_of(GetParam());
  const Robot50 robot = reference_robot<Real50>(model.robot, {}), other = shaken(robot);
  std::vector<MotionLimits> limits(static_cast<std::size_t>(model.mechanism.size()), {1, 5, 20});
  std::vector<State> states = random_states(model.mechanism, 40, 1);
  for (State& state : states) {
    for (std::size_t k = 0; k < limits.size(); ++k) {
      if (model.mechanism.bodies[k].prismatic) state.q[k] = std::remainder(state.q[k], 1);
      state.qd[k] = state.qd[k] > 0 ? 5 : -5;
      state.qdd[k] = state.qdd[k] > 0 ? 20 : -20;
    }
  }
  const double seen = largest_difference(robot, other, states), bound = torque_difference_bound(robot, other, limits);
  EXPECT_GT(seen, 0);
  EXPECT_LE(seen, bound);
  EXPECT_LE(bound, 2000 * seen) << "of no use";
  EXPECT_EQ(torque_difference_bound(robot, robot, limits), 0);
}

INSTANTIATE_TEST_SUITE_P(Robots, DifferenceOfTorques,
                         ::testing::Values("ur5.urdf", "panda.urdf", "puma560.toml", "planar_2r_example_7_2.toml",
                                           "quadruped12.urdf", "humanoid32.urdf"));

// Force and moment on the base count, and joints differ more as the base moves.
TEST(DifferenceOfTorquesOfAFloatingBase, IsBelowItsBound) {
  LoadOptions options;
  options.read.floating_base = true;
  const LoadedRobot model = load_robot(FLATDYN_SOURCE_DIR "/robots/quadruped12.urdf", options);
  const Robot50 robot = reference_robot<Real50>(model.robot, {}), other = shaken(robot);
  std::vector<State> states = random_states(model.mechanism, 40, 1);
  for (State& state : states) {
    for (int k = 0; k < model.mechanism.size(); ++k) {
      const MotionRange range = motion_range(model.mechanism.joint(k));
      const auto at = static_cast<std::size_t>(k);
      state.qd[at] = std::copysign(range.speed, state.qd[at]);
      state.qdd[at] = std::copysign(range.acceleration, state.qdd[at]);
    }
  }
  const double seen = largest_difference(robot, other, states);
  const auto bound = [&](const Robot50& b) {
    return torque_difference_bound(robot, b, largest_motion(model.mechanism), largest_motion_of_base(model.mechanism));
  };
  EXPECT_GT(seen, 0);
  EXPECT_LE(seen, bound(other));
  EXPECT_LE(bound(other), 200 * seen) << "of no use";
  EXPECT_EQ(bound(robot), 0);
}

}  // namespace
}  // namespace flatdyn
