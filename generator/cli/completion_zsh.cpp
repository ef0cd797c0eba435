// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/completion.hpp"

namespace flatdyn {
namespace {

// The action of zsh's _arguments that completes a value.
std::string zsh_action(const CompletedValue& value) {
  switch (value.kind) {
    case Completed::nothing:
    case Completed::any:
      return " ";
    case Completed::files:
      return "_files";
    case Completed::folders:
      return "_files -/";
    case Completed::functions:
      return "_values -s , function $functions";
    case Completed::commands:
      return "($commands)";
    case Completed::words:
      return fmt::format("({})", in_one_line(value.words));
  }
  return " ";
}

// Specifications of an option's names: "'*--scalar=[meaning]:TEXT:(double float)'". The value of a long name may be
// joined by =, that of a short one follows at once or as the next word.
std::string zsh_specifications(const ListedOption& option) {
  std::string text;
  const std::string meaning = plain_summary(option.meaning);
  for (const std::string& name : option.names) {
    const char* const joined = option.value.empty() ? "" : name.starts_with("--") ? "=" : "+";
    const std::string value =
        option.value.empty() ? "" : fmt::format(":{}:{}", "value", zsh_action(completed_value(option)));
    text += fmt::format(" \\\n        '*{}{}[{}]{}'", name, joined, meaning, value);
  }
  return text;
}

std::string case_of(const CLI::App& command) {
  std::string text = fmt::format("    {})\n      _arguments -s", command.get_name());
  for (const ListedOption& option : listed_options(command)) text += zsh_specifications(option);
  const CompletedValue argument = completed_argument(command);
  if (argument.kind != Completed::nothing) text += fmt::format(" \\\n        '*:argument:{}'", zsh_action(argument));
  return text + "\n      ;;\n";
}

}  // namespace

std::string zsh_completion(const CLI::App& app) {
  std::string described, cases;
  for (const CLI::App* command : subcommands(app)) {
    described += fmt::format("    '{}:{}'\n", command->get_name(), plain_summary(description_of(*command).first));
    cases += case_of(*command);
  }
  return fmt::format(R"(#compdef flatdyn
# zsh completion for flatdyn, made by `flatdyn completion zsh`.
_flatdyn() {{
  local -a commands functions described
  commands=({})
  functions=({})
  described=(
{}  )
  if ((CURRENT == 2)); then
    _describe command described
    return
  fi
  shift words
  ((CURRENT--))
  case ${{words[1]}} in
{}  esac
}}
if [[ ${{funcstack[1]}} == _flatdyn ]]; then
  _flatdyn "$@"
else
  compdef _flatdyn flatdyn
fi
)",
                     in_one_line(command_names(app)), in_one_line(function_names()), described, cases);
}

}  // namespace flatdyn
