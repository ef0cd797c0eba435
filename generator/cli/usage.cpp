// SPDX-License-Identifier: GPL-2.0-or-later
#include "cli/usage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>

#include "base/diagnostics/nearest.hpp"
#include "cli/option_list.hpp"

namespace flatdyn {
namespace {

bool is_option(const std::string& word) { return word.size() > 1 && word.front() == '-'; }

// The option's name: "--funtions=a" gives "--funtions".
std::string name_of_option(const std::string& word) { return word.substr(0, word.find('=')); }

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const ListedOption& option : listed_options(command)) {
    names.insert(names.end(), option.names.begin(), option.names.end());
  }
  return names;
}

// The subcommand on the command line, or the program itself.
const CLI::App& chosen(const CLI::App& app) {
  const std::vector<CLI::App*> commands = app.get_subcommands();
  return commands.empty() ? app : *commands.front();
}

std::string called(const CLI::App& app, const CLI::App& command) {
  return &app == &command ? app.get_name() : app.get_name() + " " + command.get_name();
}

Failure unknown_option(const CLI::App& app, const CLI::App& command, const std::string& word) {
  const std::string name = name_of_option(word);
  return {FailureKind::usage, fmt::format("{} has no option {}", called(app, command), name),
          hint_for_unknown(name, option_names(command), "options")};
}

Failure unknown_subcommand(const CLI::App& app, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::App* command : subcommands(app)) names.push_back(command->get_name());
  return {FailureKind::usage, "there is no subcommand \"" + word + "\"", hint_for_unknown(word, names, "subcommands")};
}

// The message for the middle of a line; CLI11 begins messages with a capital letter or with the option's name.
std::string as_part_of_a_line(std::string message) {
  const bool is_word =
      message.size() > 1 && (message[1] == ' ' || std::islower(static_cast<unsigned char>(message[1])));
  if (is_word) message[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(message[0])));
  return message;
}

// An option of one value that has several; nullptr if there is none.
const CLI::Option* given_too_often(const CLI::App& command) {
  const std::vector<const CLI::Option*> options = command.get_options();
  const auto found = std::find_if(options.begin(), options.end(), [](const CLI::Option* option) {
    return option->get_items_expected_max() == 1 && option->count() > 1 &&
           option->get_multi_option_policy() == CLI::MultiOptionPolicy::Throw;
  });
  return found == options.end() ? nullptr : *found;
}

}  // namespace

const CLI::App& subcommand_named(const CLI::App& app, const std::string& name) {
  for (const CLI::App* command : subcommands(app)) {
    if (command->get_name() == name) return *command;
  }
  throw unknown_subcommand(app, name);
}

Failure usage_failure(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& command = chosen(app);
  const std::vector<std::string> left_over = command.remaining();
  const auto option = std::find_if(left_over.begin(), left_over.end(), is_option);
  if (option != left_over.end()) return unknown_option(app, command, *option);
  if (&command == &app && !left_over.empty()) return unknown_subcommand(app, left_over.front());
  const std::string hint = called(app, command) + " --help shows what it takes";
  if (!left_over.empty()) {
    return {FailureKind::usage,
            fmt::format("{}: \"{}\" is more than it takes", called(app, command), left_over.front()), hint};
  }
  if (const CLI::Option* repeated = given_too_often(command)) {
    return {FailureKind::usage, fmt::format("{} is given {} times", repeated->get_name(), repeated->count()),
            "give it once; " + hint};
  }
  return {FailureKind::usage, as_part_of_a_line(error.what()), hint};
}

OutputStyle output_style_of(const CLI::App& app) {
  const CLI::App& command = chosen(app);
  const auto is_given = [&command](const char* name) {
    const CLI::Option* option = command.get_option_no_throw(name);
    return option != nullptr && option->count() > 0;
  };
  return {is_given("--quiet"), is_given("--verbose"), is_given("--json")};
}

OutputStyle output_style_of(int argc, const char* const* argv) {
  const auto is_json = [](std::string_view word) { return word == "--json"; };
  return {.json = std::any_of(argv, argv + argc, is_json)};
}

}  // namespace flatdyn
