// SPDX-License-Identifier: GPL-2.0-or-later
// Messages in the program's own words for command lines that CLI11 refuses.
#pragma once

#include <CLI/CLI.hpp>

#include "base/diagnostics/findings_text.hpp"

namespace flatdyn {

// The failure with a hint: the nearest name for a misspelt option, for anything else the page to read.
Failure usage_failure(const CLI::App& app, const CLI::ParseError& error);

// The subcommand of this name. Throws Failure(usage) if there is none.
const CLI::App& subcommand_named(const CLI::App& app, const std::string& name);

// The output style of the chosen subcommand, as far as the command line shows it before anything is parsed.
OutputStyle output_style_of(const CLI::App& app);
OutputStyle output_style_of(int argc, const char* const* argv);

}  // namespace flatdyn
