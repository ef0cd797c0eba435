// SPDX-License-Identifier: GPL-2.0-or-later
#include "unit/layout/source_files.hpp"

#include <algorithm>
#include <fstream>

namespace flatdyn::testing {

std::vector<std::string> lines_of(const std::filesystem::path& path) {
  std::ifstream in(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::vector<SourceFile> source_files(const std::string& top) {
  const std::filesystem::path root = std::filesystem::path(FLATDYN_SOURCE_DIR) / top;
  std::vector<SourceFile> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
    const std::filesystem::path& path = entry.path();
    if (path.extension() != ".hpp" && path.extension() != ".cpp") continue;
    const std::filesystem::path name = std::filesystem::relative(path, root);
    files.push_back({path, name.string(), name.parent_path().string(), lines_of(path)});
  }
  std::sort(files.begin(), files.end(), [](const SourceFile& a, const SourceFile& b) { return a.name < b.name; });
  return files;
}

}  // namespace flatdyn::testing
