// SPDX-License-Identifier: GPL-2.0-or-later
// The project's own sources, for tests of their layout.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace flatdyn::testing {

struct SourceFile {
  std::filesystem::path path;      // absolute
  std::string name;                // path below the given folder, "robot/model/robot.hpp"
  std::string folder;              // "robot/model"
  std::vector<std::string> lines;  // the first is line 1
};

// All .hpp and .cpp files below a folder of the project, such as "generator", sorted by name.
std::vector<SourceFile> source_files(const std::string& top);

// The lines of a file of the project.
std::vector<std::string> lines_of(const std::filesystem::path& path);

}  // namespace flatdyn::testing
