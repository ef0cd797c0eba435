// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace flatdyn {

struct TextFile {
  std::filesystem::path path;
  std::string text;
};

// Writes all of them beside their places and renames them at the end, so that nobody ever sees half a file and an
// interrupted run loses nothing. A link stays a link; a device is written to. Throws Failure(io).
void write_files(const std::vector<TextFile>& wanted);

}  // namespace flatdyn
