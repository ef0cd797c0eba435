// SPDX-License-Identifier: GPL-2.0-or-later
// The command line as data: for manual pages, for the pages of docs/commands/, and for completion.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace flatdyn {

// The heading in --help of the options that every command for a robot has; the command's own options stand before it.
inline constexpr const char* kCommonOptions = "Options for any robot";

struct ListedOption {
  std::vector<std::string> names;    // "-o", "--output"
  std::string value;                 // "FOLDER"; empty for a flag
  std::vector<std::string> choices;  // possible values, if they are limited
  std::string standard;              // the default, if the program has one
  std::string meaning;
  bool is_common = false;  // for any robot
};

// The paragraphs of a command's description are for people; its indented lines are commands to copy.
struct Description {
  std::string first, text, examples;
};
Description description_of(const CLI::App& command);

ListedOption listed_option(const CLI::Option& option);
// The options in the order of --help, without positional ones.
std::vector<ListedOption> listed_options(const CLI::App& command);
std::vector<const CLI::Option*> positionals(const CLI::App& command);
std::vector<const CLI::App*> subcommands(const CLI::App& app);

}  // namespace flatdyn
