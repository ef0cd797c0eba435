// SPDX-License-Identifier: GPL-2.0-or-later
// Commands run for their result, their time and their memory.
#pragma once

#include <filesystem>
#include <string>

namespace flatdyn {

struct Finished {
  int status = 0;           // as a shell says it; 128 + n after signal n
  double seconds = 0;       // of processor time, of the command and all that it started
  long peak_kilobytes = 0;  // of memory, of the largest process of these
};

// Runs a shell's command in `folder`; `pinned`: on one core only, the last one that this process may use.
Finished run_command(const std::string& command, const std::filesystem::path& folder, bool pinned = false);

std::string content_of_file(const std::filesystem::path& path);

// Throws Failure(io).
void write_file(const std::filesystem::path& path, const std::string& text);

}  // namespace flatdyn
