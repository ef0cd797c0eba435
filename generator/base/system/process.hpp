// SPDX-License-Identifier: GPL-2.0-or-later
// Commands of the machine's shell, and files exchanged with them.
#pragma once

#include <filesystem>
#include <string>

namespace flatdyn {

// Runs a shell command in `folder`; `pinned`: on one core only, the last one that this process may use. Returns the
// shell's exit status: 128 + n after signal n. Throws Failure(interrupted) if Ctrl-C has ended it.
int run_command(const std::string& command, const std::filesystem::path& folder, bool pinned = false);

// The text quoted as one word of a shell command.
std::string shell_word(const std::string& text);

// The compiler, $CXX or c++. Throws Failure(io) if it cannot be run.
std::string machine_compiler();

// The content of a file; empty if it cannot be read.
std::string content_of_file(const std::filesystem::path& path);

// Writes the text. Throws Failure(io).
void write_file(const std::filesystem::path& path, const std::string& text);

}  // namespace flatdyn
