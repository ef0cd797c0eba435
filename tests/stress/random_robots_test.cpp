// SPDX-License-Identifier: GPL-2.0-or-later
// A fault that a pass might have is found among random robots, and its robot is simplified.
#include "laboratory/stress/random_robots.hpp"

#include <gtest/gtest.h>

#include "report/random_robots_report.hpp"
#include "support/mutants.hpp"

namespace flatdyn {
namespace {

// Gravity without the last term of its last sum.
Function without_a_term(const Function& function) {
  if (function.name != "gravity") return function;
  for (NodeId id = function.graph.size() - 1; id >= 0; --id) {
    if (function.graph[id].op == Op::sum && function.graph[id].terms.size() > 1) {
      return testing::mutant(function, id, testing::MutantKind::drop_term);
    }
  }
  return function;
}

RandomRobotsReport report_of(const RandomRobotsOptions& options) {
  Progress quiet(true);
  return stress_random_robots(options, quiet);
}

TEST(RandomRobots, WithAMistakeAreFoundAndMadeSmall) {
  RandomRobotsOptions options;
  options.robots = 40;
  options.functions = {"gravity"};
  EXPECT_TRUE(report_of(options).passed());
  options.corrupt = without_a_term;
  const RandomRobotsReport report = report_of(options);
  ASSERT_FALSE(report.passed());
  for (const RandomRobotFailure& failure : report.failures) {
    EXPECT_EQ(failure.last.function, "gravity");
    EXPECT_EQ(failure.last.how, RandomRobotFault::How::text);
    EXPECT_LE(failure.smallest.links.size(), 2u) << failure.file;
    EXPECT_LT(failure.file.size(), robot_file(failure.drawn).size());
    EXPECT_NE(failure.file.find("flatdyn stress --family random"), std::string::npos);
    // Nothing more can be removed.
    for (const PlainLink& link : failure.smallest.links) EXPECT_FALSE(link.has_motor) << failure.file;
  }
}

// The compiled text is called, not only the text executed.
TEST(RandomRobots, AreCompiled) {
  RandomRobotsOptions options;
  options.robots = 30;
  options.compiled_one_in = 1;
  options.functions = {"gravity", "inertia_matrix"};
  const RandomRobotsReport report = report_of(options);
  EXPECT_TRUE(report.passed()) << random_robots_text(report);
  EXPECT_EQ(report.compiled, 30);
}

TEST(PlainRobots, AreTheSameEveryTimeAndOfEverySort) {
  int prismatic = 0, motors = 0, large = 0, trees = 0, floating = 0, spherical = 0;
  for (unsigned seed = 1; seed <= 300; ++seed) {
    const PlainRobot robot = plain_robot(seed);
    EXPECT_EQ(robot_file(robot), robot_file(plain_robot(seed)));
    large += robot.links.size() > 4 ? 1 : 0;
    floating += robot.base ? 1 : 0;
    for (std::size_t k = 0; k < robot.links.size(); ++k) {
      prismatic += robot.links[k].is_prismatic ? 1 : 0;
      motors += robot.links[k].has_motor ? 1 : 0;
      spherical += robot.links[k].is_spherical ? 1 : 0;
      trees += robot.links[k].parent == static_cast<int>(k) ? 0 : 1;
    }
  }
  for (const int count : {prismatic, motors, large, trees, floating, spherical}) EXPECT_GT(count, 0);
}

TEST(PlainRobots, SimplerOnesComeToAnEnd) {
  PlainRobot robot = plain_robot(4);
  int steps = 0;
  for (std::vector<PlainRobot> next = simpler_robots(robot); !next.empty(); next = simpler_robots(robot), ++steps) {
    robot = next.back();
    ASSERT_LT(steps, 10'000);
  }
  EXPECT_EQ(robot.links.size(), 1u);
}

}  // namespace
}  // namespace flatdyn
