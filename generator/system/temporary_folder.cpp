// SPDX-License-Identifier: GPL-2.0-or-later
#include "system/temporary_folder.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>

#include "diagnostics/diagnostics.hpp"
#include "system/interrupt.hpp"

namespace flatdyn {

namespace fs = std::filesystem;

fs::path temporary_root() {
  std::error_code error;
  fs::path root = fs::temp_directory_path(error);
  if (!error) return root;
  const char* chosen = std::getenv("TMPDIR");
  throw Failure(
      ExitCode::io,
      chosen == nullptr ? "/tmp is no folder" : "TMPDIR is \"" + std::string(chosen) + "\", which is no folder",
      "set TMPDIR to a folder for temporary files");
}

TemporaryFolder::TemporaryFolder() {
  std::string pattern = (temporary_root() / "flatdyn-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) {
    throw Failure(ExitCode::io, pattern + ": no temporary folder can be made: " + std::strerror(errno),
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
