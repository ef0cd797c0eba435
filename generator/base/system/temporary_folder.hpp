// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace flatdyn {

// The root of temporary folders, $TMPDIR or /tmp. Throws Failure(io), with its name, if it is not a folder.
std::filesystem::path temporary_root();

// Throws Failure(io) if a program that failed in the folder had no room for its files: its messages say so, or a file
// of a MiB cannot be written there now.
void check_room(const std::filesystem::path& folder, const std::string& messages);

// A folder that is removed with the object, also if its construction fails half-way, or if Ctrl-C or another signal
// ends the program. Throws Failure(io).
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace flatdyn
