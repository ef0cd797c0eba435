// SPDX-License-Identifier: GPL-2.0-or-later
// Real URDF files, if the folder exists (FLATDYN_EXTRA_ROBOTS, or ../shared/robots beside the sources): each one
// verifies, or is refused with the reason.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "cli/program.hpp"

namespace flatdyn::testing {
namespace {

namespace fs = std::filesystem;

fs::path folder() {
  const char* given = std::getenv("FLATDYN_EXTRA_ROBOTS");
  return given != nullptr ? fs::path(given) : fs::path(FLATDYN_SOURCE_DIR) / ".." / "shared" / "robots";
}

class ExtraRobots : public ::testing::TestWithParam<const char*> {};

TEST_P(ExtraRobots, Verifies) {
  const fs::path file = folder() / GetParam();
  if (!fs::exists(file)) GTEST_SKIP() << "no such file: " << file;
  const Outcome outcome = run_flatdyn("verify '" + file.string() +
                                      "' --quiet --states 5 --functions "
                                      "inverse_dynamics,inertia_matrix,gravity,bias,forward_dynamics,jacobian");
  EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
}

INSTANTIATE_TEST_SUITE_P(Files, ExtraRobots,
                         ::testing::Values("anymal_c.urdf", "double_pendulum.urdf", "panda.urdf", "solo12.urdf",
                                           "talos_left_arm.urdf", "talos_reduced.urdf", "ur5_robot.urdf", "z1.urdf"),
                         [](const auto& test) { return fs::path(test.param).stem().string(); });

}  // namespace
}  // namespace flatdyn::testing
