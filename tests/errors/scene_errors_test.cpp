// SPDX-License-Identifier: GPL-2.0-or-later
// One scene file per diagnostic in scenes/, over bases/scene_arm.toml, with the exact text that it gives in
// NAME.expected, to be renewed as those of errors_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

#include "functions/planning/make_functions.hpp"

namespace flatdyn {
namespace {

namespace fs = std::filesystem;

const fs::path kScenes = fs::path(FLATDYN_SOURCE_DIR) / "tests" / "errors" / "scenes";

std::vector<std::string> scene_files() {
  std::vector<std::string> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(kScenes)) {
    if (entry.path().extension() == ".toml") files.push_back(entry.path().filename().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

class SceneErrors : public ::testing::TestWithParam<std::string> {
 protected:
  SceneErrors() { fs::current_path(kScenes); }

  // All that is said from the reader to the functions.
  static Diagnostics found() {
    PipelineOptions options;
    options.read.scene_file = GetParam();
    Progress quiet(true);
    Diagnostics findings;
    try {
      const LoadedRobot model = load_robot("../bases/scene_arm.toml", options);
      findings = model.diagnostics;
      if (model.robot.scene.functions.empty() && model.robot.scene.outputs.empty()) options.functions = {"gravity"};
      make_functions(model, options, quiet, findings);
    } catch (const BadInput& bad) {
      return bad.diagnostics;
    }
    return findings;
  }
};

TEST_P(SceneErrors, HaveTheExactTextAndAHint) {
  const Diagnostics diagnostics = found();
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    text += to_string(diagnostic) + "\n";
    EXPECT_FALSE(diagnostic.hint.empty()) << to_string(diagnostic);
    EXPECT_FALSE(diagnostic.place.file.empty()) << to_string(diagnostic);
  }
  EXPECT_FALSE(text.empty());
  const fs::path expected = kScenes / fs::path(GetParam()).replace_extension(".expected");
  if (std::getenv("FLATDYN_UPDATE_EXPECTED") != nullptr) std::ofstream(expected, std::ios::binary) << text;
  std::ostringstream wanted;
  wanted << std::ifstream(expected, std::ios::binary).rdbuf();
  EXPECT_EQ(text, wanted.str());
}

INSTANTIATE_TEST_SUITE_P(Scenes, SceneErrors, ::testing::ValuesIn(scene_files()),
                         [](const auto& test) { return fs::path(test.param).stem().string(); });

}  // namespace
}  // namespace flatdyn
