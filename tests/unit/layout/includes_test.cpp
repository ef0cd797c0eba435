// SPDX-License-Identifier: GPL-2.0-or-later
// The table in generator/README.md lists the folders in order: a folder includes only folders above it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <regex>
#include <set>

#include "unit/layout/source_files.hpp"

namespace flatdyn::testing {
namespace {

// The folders of the table "Folders", in its order: the first cell of a row is `folder/`.
std::map<std::string, int> folders_in_order() {
  static const std::regex kRow(R"(^\| `([a-z_/0-9]+)/` \|.*)");
  std::map<std::string, int> order;
  std::smatch match;
  for (const std::string& line : lines_of(std::filesystem::path(FLATDYN_SOURCE_DIR) / "generator/README.md")) {
    if (std::regex_match(line, match, kRow)) order.emplace(match[1], static_cast<int>(order.size()));
  }
  return order;
}

// "robot/model" for `#include "robot/model/robot.hpp"`; nullopt for other lines, and for headers of folders outside the
// table.
std::optional<std::string> included_folder(const std::string& line, const std::map<std::string, int>& order) {
  static const std::regex kInclude("^#include \"(.*)/[^/]+\"$");
  std::smatch match;
  if (!std::regex_match(line, match, kInclude) || order.count(match[1]) == 0) return std::nullopt;
  return match[1].str();
}

std::vector<std::string> broken_rules(const std::vector<SourceFile>& files, const std::map<std::string, int>& order) {
  std::vector<std::string> broken;
  for (const SourceFile& file : files) {
    for (std::size_t k = 0; k < file.lines.size(); ++k) {
      const std::optional<std::string> folder = included_folder(file.lines[k], order);
      if (!folder || *folder == file.folder || order.at(*folder) < order.at(file.folder)) continue;
      broken.push_back(fmt::format("generator/{}:{}: {}/ includes {}/, which stands below it in generator/README.md",
                                   file.name, k + 1, file.folder, *folder));
    }
  }
  return broken;
}

TEST(Layout, TableListsEveryFolderOfTheGenerator) {
  const std::map<std::string, int> order = folders_in_order();
  std::set<std::string> listed, found;
  for (const auto& [folder, place] : order) listed.insert(folder);
  for (const SourceFile& file : source_files("generator")) found.insert(file.folder);
  EXPECT_EQ(listed, found);
}

TEST(Layout, FoldersIncludeOnlyFoldersAboveThem) {
  const std::vector<std::string> broken = broken_rules(source_files("generator"), folders_in_order());
  for (const std::string& rule : broken) ADD_FAILURE() << rule;
}

TEST(Layout, AnIncludeOfAFolderBelowIsFound) {
  const std::vector<SourceFile> files = {
      {"", "graph/a.cpp", "graph", {"#include \"graph/b.hpp\"", "#include \"emit/c.hpp\""}},
      {"", "emit/d.cpp", "emit", {"#include \"graph/b.hpp\""}}};
  EXPECT_EQ(broken_rules(files, {{"graph", 0}, {"emit", 1}}),
            std::vector<std::string>{
                "generator/graph/a.cpp:2: graph/ includes emit/, which stands below it in generator/README.md"});
}

}  // namespace
}  // namespace flatdyn::testing
