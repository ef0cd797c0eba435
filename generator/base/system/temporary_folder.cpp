// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/system/temporary_folder.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>

#include "base/diagnostics/diagnostics.hpp"
#include "base/system/interrupt.hpp"

namespace flatdyn {

namespace fs = std::filesystem;

fs::path temporary_root() {
  std::error_code error;
  fs::path root = fs::temp_directory_path(error);
  if (!error) return root;
  const char* chosen = std::getenv("TMPDIR");
  throw Failure(
      FailureKind::io,
      chosen == nullptr ? "/tmp is no folder" : "TMPDIR is \"" + std::string(chosen) + "\", which is no folder",
      "set TMPDIR to a folder for temporary files");
}

namespace {

bool can_hold_a_mebibyte(const fs::path& folder) {
  const fs::path trial = folder / "room";
  std::ofstream file(trial, std::ios::binary);
  file << std::string(std::size_t{1} << 20U, ' ');
  file.close();
  const bool is_written = !file.fail();
  std::error_code ignored;
  fs::remove(trial, ignored);
  return is_written;
}

}  // namespace

void check_room(const fs::path& folder, const std::string& messages) {
  const bool is_said = messages.find(std::strerror(ENOSPC)) != std::string::npos ||
                       messages.find(std::strerror(EDQUOT)) != std::string::npos;
  if (!is_said && can_hold_a_mebibyte(folder)) return;
  throw Failure(FailureKind::io, folder.string() + ": there is no room for temporary files",
                "make room, or set TMPDIR to a folder of another disk");
}

TemporaryFolder::TemporaryFolder() {
  std::string pattern = (temporary_root() / "flatdyn-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) {
    throw Failure(FailureKind::io, pattern + ": no temporary folder can be made: " + std::strerror(errno),
                  "set TMPDIR to a folder that can be written to");
  }
  path_ = pattern;
  remove_when_interrupted(path_);
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
  keep_when_interrupted(path_);
}

}  // namespace flatdyn
