// SPDX-License-Identifier: GPL-2.0-or-later
// Commands of the machine's shell, and the files through which one talks with them.
#pragma once

#include <filesystem>
#include <string>

namespace flatdyn {

// Runs a shell's command in `folder`; `pinned`: on one core only, the last one that this process may use. Returns what
// a shell says: 128 + n after signal n. Throws Failure(interrupted) if Ctrl-C has ended it.
int run_command(const std::string& command, const std::filesystem::path& folder, bool pinned = false);

// The text as one word of such a command, whatever is in it.
std::string shell_word(const std::string& text);

// $CXX, or c++. Throws Failure(io) if it cannot be run.
std::string machine_compiler();

std::string content_of_file(const std::filesystem::path& path);

// Throws Failure(io).
void write_file(const std::filesystem::path& path, const std::string& text);

}  // namespace flatdyn
