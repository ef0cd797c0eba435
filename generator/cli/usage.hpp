// SPDX-License-Identifier: GPL-2.0-or-later
// Command lines that CLI11 refuses, in the program's own words.
#pragma once

#include <CLI/CLI.hpp>

#include "diagnostics/command_output.hpp"

namespace flatdyn {

// What is wrong, and what to do: a misspelt option gets the nearest one, anything else the page to read.
Failure usage_failure(const CLI::App& app, const CLI::ParseError& error);

// How the chosen subcommand is to tell things. Before anything was parsed, as far as the words say it.
Manner manner_of(const CLI::App& app);
Manner manner_of(int argc, const char* const* argv);

}  // namespace flatdyn
