// SPDX-License-Identifier: GPL-2.0-or-later
// The references in docs/commands/: the same words as --help, in Markdown. `scripts/docs` puts them into the pages.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace flatdyn {

// The command's description, examples, arguments and options, for docs/commands/NAME.md.
std::string markdown_of_command(const CLI::App& command);

// All commands, and the options for any robot, for docs/commands/README.md.
std::string markdown_of_program(const CLI::App& app);

}  // namespace flatdyn
