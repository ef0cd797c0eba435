// SPDX-License-Identifier: GPL-2.0-or-later
// The mechanism is the robot as read, and any changed number of it is found.
#include "definition/as_read.hpp"

#include <gtest/gtest.h>

#include "support/robot_models.hpp"
#include "support/robots.hpp"

namespace flatdyn {
namespace {

TEST(AsRead, HoldsForEveryRobotOfTheProject) {
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(FLATDYN_SOURCE_DIR) / "robots")) {
    const LoadedRobot model = load_robot(entry.path(), {});
    const auto start = std::chrono::steady_clock::now();
    const AsReadResult result = prove_as_read(model.robot, model.mechanism);
    const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    EXPECT_TRUE(result.holds) << entry.path() << ": " << result.summary();
    std::cerr << entry.path().filename() << ' ' << ms << " ms " << result.summary() << '\n';
  }
}

TEST(AsRead, HoldsForRandomTrees) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const Robot robot = testing::random_tree(seed, 6);
    const AsReadResult result = prove_as_read(robot, make_mechanism(robot));
    EXPECT_TRUE(result.holds) << robot.name << ": " << result.summary();
    std::cerr << robot.name << ' ' << result.summary() << '\n';
  }
}

}  // namespace
}  // namespace flatdyn
