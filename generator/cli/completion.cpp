// SPDX-License-Identifier: GPL-2.0-or-later
// Completion for bash, made from the options as they are declared.
#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/option_list.hpp"
#include "functions/function_table.hpp"

namespace flatdyn {
namespace {

std::string words(const std::vector<std::string>& all) { return fmt::format("{}", fmt::join(all, " ")); }

// The bash command that completes a value; empty if any text may follow.
std::string action_for(const ListedOption& option) {
  if (!option.choices.empty()) return fmt::format("_flatdyn_words \"{}\"", words(option.choices));
  if (option.value == "FOLDER") return "_flatdyn_files -d";
  if (option.value == "FILE") return "_flatdyn_files -f";
  if (option.value == "NAMES") return "_flatdyn_functions";
  return option.value.empty() ? "" : ":";
}

std::string cases_of(const CLI::App& command) {
  std::string cases;
  std::vector<std::string> names;
  for (const ListedOption& option : listed_options(command)) {
    names.insert(names.end(), option.names.begin(), option.names.end());
    const std::string action = action_for(option);
    if (action.empty()) continue;
    std::string patterns;
    for (const std::string& name : option.names) {
      patterns += fmt::format("{}\"{} {}\"", patterns.empty() ? "" : " | ", command.get_name(), name);
    }
    cases += fmt::format("    {}) {} ;;\n", patterns, action);
  }
  return cases + fmt::format("    \"{} \"*) _flatdyn_options \"{}\" ;;\n", command.get_name(), words(names));
}

std::string script(const CLI::App& app) {
  std::vector<std::string> commands, functions;
  std::string cases;
  for (const CLI::App* command : subcommands(app)) {
    commands.push_back(command->get_name());
    cases += cases_of(*command);
  }
  for (const FunctionRow& row : function_table()) functions.emplace_back(row.name);
  return "# bash completion for flatdyn, made by `flatdyn completion`.\n"
         "_flatdyn_words() { mapfile -t COMPREPLY < <(compgen -W \"$1\" -- \"$word\"); }\n"
         "_flatdyn_files() {\n"
         "  compopt -o filenames\n"
         "  mapfile -t COMPREPLY < <(compgen \"$1\" -- \"$word\")\n"
         "}\n"
         "# The last of a list with commas.\n"
         "_flatdyn_functions() {\n"
         "  local before=\n"
         "  [[ $word == *,* ]] && before=${word%,*},\n"
         "  compopt -o nospace\n" +
         fmt::format("  mapfile -t COMPREPLY < <(compgen -P \"$before\" -W \"{}\" -- \"${{word##*,}}\")\n",
                     words(functions)) +
         "}\n"
         "_flatdyn_options() { if [[ $word == -* ]]; then _flatdyn_words \"$1\"; else _flatdyn_files -f; fi; }\n"
         "_flatdyn() {\n"
         "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}\n"
         "  COMPREPLY=()\n"
         "  if ((COMP_CWORD == 1)); then\n" +
         fmt::format("    _flatdyn_words \"{} --help --version\"\n", words(commands)) +
         "    return\n"
         "  fi\n"
         "  case \"${COMP_WORDS[1]} $before\" in\n" +
         cases +
         "  esac\n"
         "}\n"
         "complete -F _flatdyn flatdyn\n";
}

}  // namespace

Run add_completion(CLI::App& app) {
  app.add_subcommand("completion",
                     "Print what makes bash complete flatdyn's subcommands, options and functions.\n\n"
                     "  source <(flatdyn completion)");
  return [&app] {
    fmt::print("{}", script(app));
    return ExitCode::ok;
  };
}

}  // namespace flatdyn
