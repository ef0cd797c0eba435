// SPDX-License-Identifier: GPL-2.0-or-later
// Scripts by which shells complete command lines, made from the options as they are declared.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "cli/option_list.hpp"

namespace flatdyn {

std::string bash_completion(const CLI::App& app);
std::string zsh_completion(const CLI::App& app);
std::string fish_completion(const CLI::App& app);

// The kinds of words that may follow as the value of an option, or as an argument.
enum class Completed { nothing, any, files, folders, functions, commands, words };
struct CompletedValue {
  Completed kind = Completed::nothing;
  std::vector<std::string> words;  // of the last kind
};
CompletedValue completed_value(const ListedOption& option);
// The value of the command's arguments that are not options.
CompletedValue completed_argument(const CLI::App& command);

// The words with blanks between.
std::string in_one_line(const std::vector<std::string>& words);
std::vector<std::string> command_names(const CLI::App& app);
std::vector<std::string> function_names();
// The first line of a meaning, without characters that shells take for their own.
std::string plain_summary(const std::string& meaning);

}  // namespace flatdyn
