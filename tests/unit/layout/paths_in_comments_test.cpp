// SPDX-License-Identifier: GPL-2.0-or-later
// A file that a comment of the program names exists: by the name that #include gives it, or by its path in the project.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include "unit/layout/source_files.hpp"

namespace flatdyn::testing {
namespace {

bool is_there(const std::string& path) {
  const std::filesystem::path root = FLATDYN_SOURCE_DIR;
  for (const char* folder : {"", "generator", "runtime/include"}) {
    if (std::filesystem::exists(root / folder / path)) return true;
  }
  return false;
}

// "robot/model/robot.hpp:12: no file x/y.hpp" for each that a comment names.
std::vector<std::string> paths_of_nothing(const SourceFile& file) {
  static const std::regex kPath(R"((?:^|[\s("`])((?:[a-z_0-9]+/)+[a-z_0-9]+\.[hc]pp(?:\.mustache)?))");
  std::vector<std::string> found;
  for (std::size_t k = 0; k < file.lines.size(); ++k) {
    const std::string& line = file.lines[k];
    const std::size_t begin = line.find("//");
    if (begin == std::string::npos) continue;
    const std::string comment = line.substr(begin + 2);
    for (std::sregex_iterator path(comment.begin(), comment.end(), kPath), end; path != end; ++path) {
      if (!is_there((*path)[1])) found.push_back(fmt::format("{}:{}: no file {}", file.name, k + 1, (*path)[1].str()));
    }
  }
  return found;
}

TEST(Layout, FilesThatCommentsNameExist) {
  for (const char* top : {"generator", "runtime"}) {
    for (const SourceFile& file : source_files(top)) {
      for (const std::string& path : paths_of_nothing(file)) ADD_FAILURE() << top << "/" << path;
    }
  }
}

TEST(Layout, FilesThatCommentsNameAreFound) {
  const SourceFile file = {
      "", "a.cpp", "", {"int a;  // as in graph/graph.hpp, not in graph/none.hpp", "// (none/b.cpp)"}};
  EXPECT_EQ(paths_of_nothing(file),
            (std::vector<std::string>{"a.cpp:1: no file graph/none.hpp", "a.cpp:2: no file none/b.cpp"}));
}

}  // namespace
}  // namespace flatdyn::testing
