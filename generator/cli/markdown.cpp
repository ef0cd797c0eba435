// SPDX-License-Identifier: GPL-2.0-or-later
#include "cli/markdown.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "base/diagnostics/wrap.hpp"
#include "cli/option_list.hpp"

namespace flatdyn {
namespace {

constexpr std::size_t kPageWidth = 120;

// Text that stands in a table as it is: no character of it is taken for Markdown or HTML, and its lines stay lines.
std::string cell(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\n') {
      result += "<br>";
      continue;
    }
    const bool is_markup = c == '|' || c == '<' || c == '*' || c == '_';
    result += is_markup ? std::string("\\") + c : std::string(1, c);
  }
  return result;
}

// Only the bar needs an escape inside of code.
std::string code(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '|' ? "\\|" : std::string(1, c);
  return text.empty() ? "" : "`" + result + "`";
}

std::string fenced(const std::string& text) { return text.empty() ? "" : "```text\n" + text + "\n```\n\n"; }

// A long list, which a page shows on request.
std::string folded(const std::string& text) {
  return text.empty() ? ""
                      : "<details><summary>The values of its options</summary>\n\n" + fenced(text) + "</details>\n\n";
}

// Examples stand two columns to the right in --help.
std::string without_indent(const std::string& text) {
  std::istringstream lines(text);
  std::string result;
  for (std::string line; std::getline(lines, line);) result += (result.empty() ? "" : "\n") + line.substr(2);
  return result;
}

std::string usage(const CLI::App& command) {
  std::string result = "flatdyn " + command.get_name() + " [OPTIONS]";
  for (const CLI::Option* argument : positionals(command)) {
    const std::string name = argument->get_name(true);
    result += argument->get_required() ? " " + name : " [" + name + "]";
  }
  return result;
}

std::string row(const ListedOption& option) {
  std::string names;
  for (const std::string& name : option.names) {
    const std::string value = option.value.empty() ? "" : " " + option.value;
    names += (names.empty() ? "" : ", ") + code(name + value);
  }
  return fmt::format("| {} | {} | {} |\n", names, code(option.standard), cell(option.meaning));
}

std::string table(const std::string& rows) {
  return rows.empty() ? "" : "| option | default | meaning |\n|---|---|---|\n" + rows + "\n";
}

struct OptionTables {
  std::string own, common, names_of_common;
};

OptionTables tables_of(const CLI::App& command) {
  OptionTables result;
  for (const ListedOption& option : listed_options(command)) {
    (option.is_common ? result.common : result.own) += row(option);
    if (!option.is_common) continue;
    result.names_of_common += (result.names_of_common.empty() ? "" : ", ") + code(option.names.back());
  }
  return result;
}

std::string rows_of_arguments(const CLI::App& command) {
  std::string rows;
  for (const CLI::Option* argument : positionals(command)) {
    rows += fmt::format("| {} | | {} |\n", code(argument->get_name(true)), cell(argument->get_description()));
  }
  return rows;
}

}  // namespace

std::string markdown_of_command(const CLI::App& command) {
  const Description about = description_of(command);
  const OptionTables options = tables_of(command);
  std::string common;
  if (!options.common.empty()) {
    common = wrapped(fmt::format("It also has the [options for any robot](README.md#options-for-any-robot): {}.",
                                 options.names_of_common),
                     kPageWidth) +
             "\n\n";
  }
  return wrapped(cell(about.text), kPageWidth) + "\n\n" +
         fenced(usage(command) + "\n\n" + without_indent(about.examples)) +
         table(rows_of_arguments(command) + options.own) + common + folded(command.get_footer());
}

std::string markdown_of_program(const CLI::App& app) {
  std::string rows, common;
  for (const CLI::App* command : subcommands(app)) {
    const std::string name = command->get_name();
    rows += fmt::format("| [`{0}`]({0}.md) | {1} |\n", name, cell(description_of(*command).first));
    if (common.empty()) common = table(tables_of(*command).common);
  }
  return "| command | |\n|---|---|\n" + rows + "\n## Options for any robot\n\n" + common;
}

}  // namespace flatdyn
