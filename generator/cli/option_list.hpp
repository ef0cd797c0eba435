// SPDX-License-Identifier: GPL-2.0-or-later
// The options of the command line as data, for manual pages and completion.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace flatdyn {

struct ListedOption {
  std::vector<std::string> names;    // "-o", "--output"
  std::string value;                 // "FOLDER"; empty for a flag
  std::vector<std::string> choices;  // possible values, if they are limited
  std::string standard;              // the default, if the program has one
  std::string meaning;
};

// The options in the order of --help, without positional ones.
std::vector<ListedOption> listed_options(const CLI::App& command);
std::vector<const CLI::Option*> positionals(const CLI::App& command);
std::vector<const CLI::App*> subcommands(const CLI::App& app);

}  // namespace flatdyn
