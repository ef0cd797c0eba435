// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>

namespace flatdyn {

// $TMPDIR, or /tmp. Throws Failure(io), which names it, if it is no folder.
std::filesystem::path temporary_root();

// Gone with the object, also when what was to be made in it fails half-way, and when Ctrl-C or another signal ends the
// program. Throws Failure(io).
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
