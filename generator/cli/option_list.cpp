// SPDX-License-Identifier: GPL-2.0-or-later
#include "cli/option_list.hpp"

#include <algorithm>
#include <sstream>

namespace flatdyn {
namespace {

// The choices in a type: "TEXT:{double,float}" gives double, float.
std::vector<std::string> choices_of(const std::string& type) {
  const std::size_t open = type.find('{'), close = type.find('}');
  if (open == std::string::npos || close == std::string::npos) return {};
  return CLI::detail::split(type.substr(open + 1, close - open - 1), ',');
}

}  // namespace

ListedOption listed_option(const CLI::Option& option) {
  ListedOption result;
  for (const std::string& name : option.get_snames()) result.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) result.names.push_back("--" + name);
  result.meaning = option.get_description();
  result.is_common = option.get_group() == kCommonOptions;
  if (option.get_type_size() == 0) return result;
  const std::string type = option.get_type_name();
  result.choices = choices_of(type);
  result.value = type.substr(0, type.find(':'));
  if (!result.choices.empty()) result.value = CLI::detail::join(result.choices, "|");
  result.standard = option.get_default_str();
  return result;
}

std::vector<ListedOption> listed_options(const CLI::App& command) {
  std::vector<ListedOption> result;
  for (const CLI::Option* option : command.get_options([](const CLI::Option* each) { return each->nonpositional(); })) {
    result.push_back(listed_option(*option));
  }
  std::stable_partition(result.begin(), result.end(), [](const ListedOption& each) { return !each.is_common; });
  return result;
}

Description description_of(const CLI::App& command) {
  Description result;
  std::istringstream lines(command.get_description());
  for (std::string line; std::getline(lines, line);) {
    std::string& part = line.rfind("  ", 0) == 0 ? result.examples : result.text;
    if (result.first.empty()) result.first = line;
    if (!line.empty()) part += (part.empty() ? "" : "\n") + line;
  }
  return result;
}

std::vector<const CLI::Option*> positionals(const CLI::App& command) {
  return command.get_options([](const CLI::Option* each) { return each->get_positional(); });
}

std::vector<const CLI::App*> subcommands(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

}  // namespace flatdyn
