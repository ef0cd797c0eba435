// SPDX-License-Identifier: GPL-2.0-or-later
#include "cli/completion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/commands.hpp"
#include "cli/output_file.hpp"
#include "functions/function_table.hpp"

namespace flatdyn {

CompletedValue completed_value(const ListedOption& option) {
  if (!option.choices.empty()) return {Completed::words, option.choices};
  if (option.value.empty()) return {};
  if (option.value == "FOLDER") return {Completed::folders, {}};
  if (option.value.starts_with("FILE")) return {Completed::files, {}};
  if (option.value == "NAMES") return {Completed::functions, {}};
  if (option.value == "COMMAND") return {Completed::commands, {}};
  return {Completed::any, {}};
}

CompletedValue completed_argument(const CLI::App& command) {
  const std::vector<const CLI::Option*> arguments = positionals(command);
  return arguments.empty() ? CompletedValue{} : completed_value(listed_option(*arguments.front()));
}

std::string in_one_line(const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, " ")); }

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : subcommands(app)) names.push_back(command->get_name());
  return names;
}

std::vector<std::string> function_names() {
  std::vector<std::string> names;
  for (const FunctionRow& row : function_table()) names.emplace_back(row.name);
  return names;
}

std::string plain_summary(const std::string& meaning) {
  constexpr std::size_t kLongest = 80;
  std::string line = meaning.substr(0, meaning.find('\n'));
  for (const char separator : {';', ':'}) {
    if (line.size() > kLongest) line = line.substr(0, line.find(separator));
  }
  if (line.size() > kLongest) line = line.substr(0, line.rfind(' ', kLongest)) + " ...";
  std::string plain;
  for (const char c : line) {
    if (c == '[' || c == '(') {
      plain += '(';
    } else if (c == ']' || c == ')') {
      plain += ')';
    } else if (c == '\'') {
      plain += "\u2019";  // an apostrophe that ends no string
    } else if (c != '"' && c != '\\' && c != '$' && c != '`' && c != ':') {
      plain += c;
    }
  }
  return plain;
}

Run add_completion(CLI::App& app) {
  auto* command =
      app.add_subcommand("completion",
                         "Print what makes a shell complete flatdyn's subcommands, options, values and functions.\n\n"
                         "  source <(flatdyn completion)\n"
                         "  source <(flatdyn completion zsh)\n"
                         "  flatdyn completion fish > ~/.config/fish/completions/flatdyn.fish");
  const auto shell = std::make_shared<std::string>("bash");
  command->add_option("shell", *shell, "bash, zsh or fish; default: bash")
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  return [&app, shell] {
    print_result(*shell == "bash"  ? bash_completion(app)
                 : *shell == "zsh" ? zsh_completion(app)
                                   : fish_completion(app));
    return ExitCode::ok;
  };
}

}  // namespace flatdyn
