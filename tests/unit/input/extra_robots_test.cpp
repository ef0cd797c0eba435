// SPDX-License-Identifier: GPL-2.0-or-later
// Real URDF files, if the folder is there: FLATDYN_EXTRA_ROBOTS, or ../shared/robots beside the sources.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "robot/input/reader.hpp"
#include "robot/model/coupling.hpp"

namespace flatdyn {
namespace {

namespace fs = std::filesystem;

struct RealRobot {
  std::string file;
  std::size_t joints;  // without those that mimic others
};

class ExtraRobots : public ::testing::TestWithParam<RealRobot> {
 protected:
  void SetUp() override {
    const char* folder = std::getenv("FLATDYN_EXTRA_ROBOTS");
    path_ = (folder != nullptr ? fs::path(folder) : fs::path(FLATDYN_SOURCE_DIR) / ".." / "shared" / "robots") /
            GetParam().file;
    if (!fs::exists(path_)) GTEST_SKIP() << "no such file: " << path_;
  }
  fs::path path_;
};

TEST_P(ExtraRobots, AreRead) {
  Diagnostics diagnostics;
  const std::optional<Robot> robot = read_robot(path_, {}, diagnostics);
  ASSERT_TRUE(robot.has_value()) << to_string(diagnostics.all().front());
  EXPECT_EQ(joints_with_coordinates(*robot).size(), GetParam().joints);
}

INSTANTIATE_TEST_SUITE_P(Files, ExtraRobots,
                         ::testing::Values(RealRobot{"anymal_c.urdf", 12}, RealRobot{"double_pendulum.urdf", 2},
                                           RealRobot{"panda.urdf", 8}, RealRobot{"solo12.urdf", 12},
                                           RealRobot{"talos_left_arm.urdf", 7}, RealRobot{"talos_reduced.urdf", 32},
                                           RealRobot{"ur5_robot.urdf", 6}, RealRobot{"z1.urdf", 7}),
                         [](const auto& test) { return fs::path(test.param.file).stem().string(); });

}  // namespace
}  // namespace flatdyn
