// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>

namespace flatdyn {

// Gone with the object, also when what was to be made in it fails half-way. Throws Failure(io).
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
