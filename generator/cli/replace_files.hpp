// SPDX-License-Identifier: GPL-2.0-or-later
// Files of one run in the place of the last run's: all of them or none, whole, and never of two runs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace flatdyn {

struct TextFile {
  std::filesystem::path path;
  std::string text;
};

// Its text, to some other place, too. Throws Failure(io).
void write_text(const std::filesystem::path& place, const TextFile& file);
[[noreturn]] void cannot_write(const std::filesystem::path& path, const std::string& why);

// Folders that are made for files, and away again if nothing comes into them.
class NewFolders {
 public:
  NewFolders() = default;
  NewFolders(const NewFolders&) = delete;
  NewFolders& operator=(const NewFolders&) = delete;
  ~NewFolders();

  // The folder of a file, with all above it. Throws Failure(io).
  void make_for(const std::filesystem::path& file);

 private:
  std::vector<std::filesystem::path> made_;  // outer ones first
};

// Writes all of them beside their places and renames them at the end, so that nobody ever sees half a file; `outdated`
// files go away with those that are replaced. If a file cannot be renamed, those of the last run are put back. If the
// run is killed, some or all of one run's are there. Of several runs in one folder, one after the other does so. Throws
// Failure(io).
void replace_files(const std::vector<TextFile>& files, const std::vector<std::filesystem::path>& outdated = {});

}  // namespace flatdyn
