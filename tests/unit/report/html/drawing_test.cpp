// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/html/drawing.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "robot/model/floating_base.hpp"
#include "support/robot_models.hpp"
#include "truth/reference/graph_evaluator.hpp"
#include "truth/reference/reference_model.hpp"

namespace flatdyn {
namespace {

// Compares every link's point and the axes of the joints with the reference.
void expect_as_the_reference(const std::string& file) {
  const LoadedRobot model = testing::model_of(file);
  const Drawing drawing = drawing_of(model.robot, model.mechanism);
  const SymbolValues symbols = random_symbol_values(model.robot, 1);
  const State state = with_parameters(random_states(model.mechanism, 1, 3), symbols).front();
  const auto values = GraphEvaluator<double>(drawing.function)(state);
  ASSERT_TRUE(values);
  reference::Robot<double> robot = reference_robot<double>(model.robot, symbols);
  reference::VectorX<double> q = vector_of(state.q);
  reference::take_orientations(robot, q);
  const auto poses = reference::link_poses(robot, q);
  for (std::size_t link = 0; link < poses.size(); ++link) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR((*values)[3 * link + k], poses[link].p[static_cast<Eigen::Index>(k)], 1e-12)
          << file << ", link " << link;
    }
  }
  const std::size_t axes = 3 * static_cast<std::size_t>(drawing.points);
  for (std::size_t joint = 0; joint < drawing.joints.size(); ++joint) {
    double square = 0;
    for (std::size_t k = 0; k < 3; ++k) square += std::pow((*values)[axes + 3 * joint + k], 2);
    EXPECT_NEAR(square, 1, 1e-14);
  }
}

TEST(Drawing, HasEveryLinkWhereItIs) {
  for (const char* file : {"panda.urdf", "scara.toml", "planar_2r.toml", "quadruped12.urdf", "finger.toml",
                           "../docs/examples/ball_wrist.toml"}) {
    expect_as_the_reference(file);
  }
}

// A base that floats carries the same picture: everything is in the base's frame.
TEST(Drawing, IsTheSameInTheFrameOfAFloatingBase) {
  const LoadedRobot model = testing::model_of("quadruped12.urdf");
  const Drawing fixed = drawing_of(model.robot, model.mechanism);
  const Drawing floating = drawing_of(model.robot, with_floating_base(model.mechanism));
  EXPECT_EQ(floating.joints, fixed.joints);
  EXPECT_EQ(floating.lines, fixed.lines);
  const State state = random_states(model.mechanism, 1, 3).front();
  const auto expected = GraphEvaluator<double>(fixed.function)(state);
  const auto values = GraphEvaluator<double>(floating.function)(state);
  ASSERT_TRUE(values && expected);
  ASSERT_EQ(values->size(), expected->size());
  for (std::size_t k = 0; k < values->size(); ++k) EXPECT_NEAR((*values)[k], (*expected)[k], 1e-12) << k;
}

// The point on the axis of a revolute joint does not move when the joint turns.
TEST(Drawing, PutsJointsOnTheirAxes) {
  for (const char* file : {"panda.urdf", "rx90.toml", "planar_2r.toml"}) {
    const LoadedRobot model = testing::model_of(file);
    const Drawing drawing = drawing_of(model.robot, model.mechanism);
    GraphEvaluator<double> evaluate(drawing.function);
    State state = with_parameters(random_states(model.mechanism, 1, 3), random_symbol_values(model.robot, 1)).front();
    const auto before = evaluate(state);
    for (std::size_t joint = 0; joint < drawing.joints.size(); ++joint) {
      State turned = state;
      turned.q[joint] += 0.7;
      const auto after = evaluate(turned);
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t at = 3 * static_cast<std::size_t>(drawing.joints[joint]) + k;
        EXPECT_NEAR((*before)[at], (*after)[at], 1e-12) << file << ", joint " << joint;
      }
    }
  }
}

TEST(Drawing, HasALinePerJointAndTheEndsOfUrdf) {
  const LoadedRobot panda = testing::model_of("panda.urdf"), arm = testing::model_of("planar_2r.toml");
  EXPECT_GE(drawing_of(panda.robot, panda.mechanism).lines.size(), panda.robot.joints.size());
  const Drawing drawn = drawing_of(arm.robot, arm.mechanism);
  EXPECT_EQ(drawn.lines.size(), 2u);  // standard DH: frames are at the ends
  EXPECT_EQ(drawn.points, 3);
}

TEST(Drawing, HasFollowersAndEndsAtTheTip) {
  const LoadedRobot finger = testing::model_of("finger.toml");
  const Drawing drawing = drawing_of(finger.robot, finger.mechanism);
  EXPECT_EQ(drawing.lines.back(), std::pair(4, 5));
  EXPECT_EQ(drawing.points, 6);
  ASSERT_EQ(drawing.followers.size(), 1U);
  EXPECT_EQ(drawing.followers[0].point, 4);
  EXPECT_FALSE(drawing.followers[0].prismatic);
  EXPECT_EQ(drawing.function.outputs[1].entries.size(), 3U * 4);
}

}  // namespace
}  // namespace flatdyn
