// SPDX-License-Identifier: GPL-2.0-or-later
#include "diagnostics/temporary_folder.hpp"

#include <cstdlib>
#include <string>

#include "diagnostics/diagnostics.hpp"

namespace flatdyn {

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder() {
  std::string pattern = (fs::temp_directory_path() / "flatdyn-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) throw Failure(ExitCode::io, "no temporary folder can be made");
  path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace flatdyn
