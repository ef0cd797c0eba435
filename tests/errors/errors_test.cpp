// SPDX-License-Identifier: GPL-2.0-or-later
// One robot file per diagnostic in a folder of cases/, with the exact text that it gives in NAME.expected. After a
// change that is meant, FLATDYN_UPDATE_EXPECTED=1 writes the files anew; the difference is then read before it is
// committed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

#include "robot/input/reader.hpp"

namespace flatdyn {
namespace {

namespace fs = std::filesystem;

const fs::path kCases = fs::path(FLATDYN_SOURCE_DIR) / "tests" / "errors" / "cases";

// The files relative to kCases: "urdf/poses/axis_zero.urdf".
std::vector<std::string> case_files() {
  std::vector<std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(kCases)) {
    if (!entry.is_regular_file() || entry.path().extension() == ".expected") continue;
    files.push_back(entry.path().lexically_relative(kCases).generic_string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string content_of(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

class Errors : public ::testing::TestWithParam<std::string> {
 protected:
  // File names in diagnostics are as given: without a folder, the expected text does not depend on the topic.
  void SetUp() override { fs::current_path((kCases / GetParam()).parent_path()); }

  static std::string file() { return fs::path(GetParam()).filename().string(); }
};

TEST_P(Errors, HasTheExactText) {
  Diagnostics diagnostics;
  const std::optional<Robot> robot = read_robot(file(), {}, diagnostics);
  EXPECT_EQ(robot.has_value(), !diagnostics.has_errors());
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics.all()) text += to_string(diagnostic) + "\n";
  EXPECT_FALSE(text.empty());
  const fs::path expected = kCases / fs::path(GetParam()).replace_extension(".expected");
  if (std::getenv("FLATDYN_UPDATE_EXPECTED") != nullptr) std::ofstream(expected, std::ios::binary) << text;
  EXPECT_EQ(text, content_of(expected));
}

TEST_P(Errors, GivesAHintForEverything) {
  Diagnostics diagnostics;
  read_robot(file(), {}, diagnostics);
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    EXPECT_FALSE(diagnostic.hint.empty()) << to_string(diagnostic);
    EXPECT_FALSE(diagnostic.place.file.empty()) << to_string(diagnostic);
  }
}

// "urdf_poses_axis_zero".
std::string name_of(const ::testing::TestParamInfo<std::string>& info) {
  std::string name = fs::path(info.param).replace_extension().generic_string();
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Cases, Errors, ::testing::ValuesIn(case_files()), name_of);

}  // namespace
}  // namespace flatdyn
