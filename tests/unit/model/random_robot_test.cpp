// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/random_robot.hpp"

#include <gtest/gtest.h>

#include "robot/model/mechanism.hpp"
#include "robot/model/validate.hpp"

namespace flatdyn::testing {
namespace {

class DrawnRobot : public ::testing::TestWithParam<bool> {};

TEST_P(DrawnRobot, IsARobotThatCanBe) {
  Robot robot = random_robot(GetParam(), 9, 3);
  Diagnostics found;
  robot.root = -1;  // to be determined
  EXPECT_TRUE(validate_tree(robot, found));
  validate_values(robot, {}, found);
  for (const Diagnostic& each : found.all()) ADD_FAILURE() << to_string(each);
  const Mechanism mechanism = make_mechanism(robot);
  EXPECT_EQ(mechanism.size(), 9);
  for (const Body& body : mechanism.bodies) EXPECT_FALSE(body.inertia.mass.is_zero());
}

TEST_P(DrawnRobot, IsTheSameForTheSameSeed) {
  const Robot a = random_robot(GetParam(), 4, 1), b = random_robot(GetParam(), 4, 1),
              c = random_robot(GetParam(), 4, 2);
  EXPECT_TRUE(a.links[4].inertials[0].mass.number.is_equal(b.links[4].inertials[0].mass.number));
  EXPECT_FALSE(a.links[4].inertials[0].tensor[0][0].is_equal(c.links[4].inertials[0].tensor[0][0]));
}

INSTANTIATE_TEST_SUITE_P(Shapes, DrawnRobot, ::testing::Bool());

TEST(DrawnRobotShape, IsAChainOrATreeOfTwos) {
  const Robot chain = random_robot(true, 7, 1), tree = random_robot(false, 7, 1);
  std::vector<int> children(8, 0);
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_EQ(chain.joints[i].parent, static_cast<int>(i));
    ++children[static_cast<std::size_t>(tree.joints[i].parent)];
  }
  EXPECT_EQ(children, (std::vector<int>{1, 2, 2, 2, 0, 0, 0, 0}));
}

}  // namespace
}  // namespace flatdyn::testing
