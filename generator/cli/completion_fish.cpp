// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/completion.hpp"

namespace flatdyn {
namespace {

// The options of fish's `complete` for a value.
std::string fish_value(const CompletedValue& value, const std::string& commands) {
  switch (value.kind) {
    case Completed::nothing:
      return "";
    case Completed::any:
      return " -x";
    case Completed::files:
      return " -r -F";
    case Completed::folders:
      return " -x -a '(__fish_complete_directories)'";
    case Completed::functions:
      return " -x -a '(__fish_complete_list , __flatdyn_functions)'";
    case Completed::commands:
      return fmt::format(" -x -a '{}'", commands);
    case Completed::words:
      return fmt::format(" -x -a '{}'", in_one_line(value.words));
  }
  return "";
}

std::string fish_names(const ListedOption& option) {
  std::string text;
  for (const std::string& name : option.names) {
    text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  }
  return text;
}

std::string fish_lines_of(const CLI::App& command, const std::string& commands) {
  const std::string begin = fmt::format("complete -c flatdyn -n '__fish_seen_subcommand_from {}'", command.get_name());
  std::string lines;
  const CompletedValue argument = completed_argument(command);
  if (argument.kind == Completed::files) {
    lines += begin + " -F\n";
  } else if (argument.kind != Completed::nothing) {
    const std::string none_yet = fmt::format(
        "complete -c flatdyn -n '__fish_seen_subcommand_from {}; and test (count (commandline -opc)) -eq 2'",
        command.get_name());
    lines += none_yet + fish_value(argument, commands) + "\n";
  }
  for (const ListedOption& option : listed_options(command)) {
    lines += fmt::format("{}{} -d '{}'{}\n", begin, fish_names(option), plain_summary(option.meaning),
                         fish_value(completed_value(option), commands));
  }
  return lines;
}

}  // namespace

std::string fish_completion(const CLI::App& app) {
  const std::string commands = in_one_line(command_names(app));
  std::string text =
      "# fish completion for flatdyn, made by `flatdyn completion fish`.\n"
      "function __flatdyn_functions\n" +
      fmt::format("  printf '%s\\n' {}\nend\n", in_one_line(function_names())) +
      "complete -c flatdyn -f\n"
      "complete -c flatdyn -n __fish_use_subcommand -l help -s h -d 'Print the help'\n"
      "complete -c flatdyn -n __fish_use_subcommand -l version -d 'Print the version'\n";
  for (const CLI::App* command : subcommands(app)) {
    text += fmt::format("complete -c flatdyn -n __fish_use_subcommand -a {} -d '{}'\n", command->get_name(),
                        plain_summary(description_of(*command).first));
  }
  for (const CLI::App* command : subcommands(app)) text += fish_lines_of(*command, commands);
  return text;
}

}  // namespace flatdyn
