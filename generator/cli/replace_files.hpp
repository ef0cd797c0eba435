// SPDX-License-Identifier: GPL-2.0-or-later
// Replaces the files of the last run by this run's: all of them or none, complete, and never a mix of two runs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace flatdyn {

// A file to be written, with its whole content.
struct TextFile {
  std::filesystem::path path;
  std::string text;
};

// Writes the file's text to `place`. Throws Failure(io).
void write_text(const std::filesystem::path& place, const TextFile& file);
[[noreturn]] void cannot_write(const std::filesystem::path& path, const std::string& why);

// Folders made for files; those that stay empty are removed again.
class NewFolders {
 public:
  NewFolders() = default;
  NewFolders(const NewFolders&) = delete;
  NewFolders& operator=(const NewFolders&) = delete;
  ~NewFolders();

  // Makes the folder of a file, with all above it. Throws Failure(io).
  void make_for(const std::filesystem::path& file);

 private:
  std::vector<std::filesystem::path> made_;  // outer ones first
};

// Writes all files next to their final places and renames them at the end, so that nobody sees an incomplete file;
// `outdated` files are removed with those that are replaced. If a file cannot be renamed, those of the last run are
// restored. If the run is killed, some or all files of one run are there. Several runs in one folder wait for each
// other. Throws Failure(io).
void replace_files(const std::vector<TextFile>& files, const std::vector<std::filesystem::path>& outdated = {});

}  // namespace flatdyn
