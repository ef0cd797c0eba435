// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include "cli/completion.hpp"

namespace flatdyn {
namespace {

// The bash command that completes a value; empty if any text may follow.
std::string bash_action(const CompletedValue& value) {
  switch (value.kind) {
    case Completed::nothing:
      return "";
    case Completed::any:
      return ":";
    case Completed::files:
      return "_flatdyn_files -f";
    case Completed::folders:
      return "_flatdyn_files -d";
    case Completed::functions:
      return "_flatdyn_functions";
    case Completed::commands:
      return "_flatdyn_words \"$commands\"";
    case Completed::words:
      return fmt::format("_flatdyn_words \"{}\"", in_one_line(value.words));
  }
  return "";
}

std::string cases_of(const CLI::App& command) {
  std::string cases;
  std::vector<std::string> names;
  for (const ListedOption& option : listed_options(command)) {
    names.insert(names.end(), option.names.begin(), option.names.end());
    const std::string action = bash_action(completed_value(option));
    if (action.empty()) continue;
    std::string patterns;
    for (const std::string& name : option.names) {
      patterns += fmt::format("{}\"{} {}\"", patterns.empty() ? "" : " | ", command.get_name(), name);
    }
    cases += fmt::format("    {}) {} ;;\n", patterns, action);
  }
  const std::string argument = bash_action(completed_argument(command));
  return cases + fmt::format("    \"{} \"*) _flatdyn_options \"{}\" {} ;;\n", command.get_name(), in_one_line(names),
                             argument.empty() ? ":" : argument);
}

// Bash splits at =: `--option=va` is the words "--option", "=" and "va".
constexpr const char* kHelpers = R"(# bash completion for flatdyn, made by `flatdyn completion`.
_flatdyn_words() { mapfile -t COMPREPLY < <(compgen -W "$1" -- "$word"); }
_flatdyn_files() {
  compopt -o filenames
  mapfile -t COMPREPLY < <(compgen "$1" -- "$word")
}
# The last of a list with commas.
_flatdyn_functions() {
  local before=
  [[ $word == *,* ]] && before=${word%,*},
  compopt -o nospace
  mapfile -t COMPREPLY < <(compgen -P "$before" -W "$functions" -- "${word##*,}")
}
# An option, or what the command takes besides: _flatdyn_options OPTIONS ACTION...
_flatdyn_options() {
  if [[ $word == -* ]]; then _flatdyn_words "$1"; else "${@:2}"; fi
}
)";

}  // namespace

std::string bash_completion(const CLI::App& app) {
  std::string cases;
  for (const CLI::App* command : subcommands(app)) cases += cases_of(*command);
  const std::string commands = in_one_line(command_names(app));
  return kHelpers + fmt::format(R"(_flatdyn() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}} joined=
  local commands="{}"
  local functions="{}"
  COMPREPLY=()
  if ((COMP_CWORD == 1)); then
    _flatdyn_words "$commands --help --version"
    return
  fi
  # Bash splits --option=value into three words, unless = is taken out of COMP_WORDBREAKS.
  if [[ $word == = ]]; then
    word=
  elif [[ $before == = ]] && ((COMP_CWORD > 2)); then
    before=${{COMP_WORDS[COMP_CWORD - 2]}}
  elif [[ $word == --*=* ]]; then
    before=${{word%%=*}} joined=${{word%%=*}}= word=${{word#*=}}
  fi
  case "${{COMP_WORDS[1]}} $before" in
{}  esac
  [[ -n $joined ]] && COMPREPLY=("${{COMPREPLY[@]/#/$joined}}")
  return 0
}}
complete -F _flatdyn flatdyn
)",
                                commands, in_one_line(function_names()), cases);
}

}  // namespace flatdyn
