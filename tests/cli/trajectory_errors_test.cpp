// SPDX-License-Identifier: GPL-2.0-or-later
// One trajectory file per diagnostic in tests/errors/trajectories/. NAME.expected has what flatdyn prints on stderr for
// it; it is updated like those of tests/errors/errors_test.cpp.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "cli/program.hpp"

namespace flatdyn::testing {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFolder = "tests/errors/trajectories";

std::vector<std::string> trajectory_files() {
  std::vector<std::string> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(fs::path(FLATDYN_SOURCE_DIR) / kFolder)) {
    if (entry.path().extension() != ".expected") files.push_back(entry.path().filename().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

class TrajectoryErrors : public ::testing::TestWithParam<std::string> {};

TEST_P(TrajectoryErrors, EndWithThreeAndTheExactText) {
  const Scratch scratch;
  const std::string file = fmt::format("{}/{}", kFolder, GetParam());
  const Outcome outcome = run_flatdyn(
      fmt::format("torques robots/planar_2r_example_7_2.toml -q --trajectory {} -o {}", file, scratch.path("out.csv")));
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, ::testing::StartsWith(file + ":"));
  EXPECT_THAT(outcome.err, ::testing::HasSubstr("hint: "));
  EXPECT_TRUE(scratch.is_empty());
  const fs::path expected = fs::path(FLATDYN_SOURCE_DIR) / fs::path(file).replace_extension(".expected");
  if (std::getenv("FLATDYN_UPDATE_EXPECTED") != nullptr) std::ofstream(expected, std::ios::binary) << outcome.err;
  std::ostringstream wanted;
  wanted << std::ifstream(expected, std::ios::binary).rdbuf();
  EXPECT_EQ(outcome.err, wanted.str());
}

INSTANTIATE_TEST_SUITE_P(Trajectories, TrajectoryErrors, ::testing::ValuesIn(trajectory_files()),
                         [](const auto& test) { return fs::path(test.param).stem().string(); });

}  // namespace
}  // namespace flatdyn::testing
