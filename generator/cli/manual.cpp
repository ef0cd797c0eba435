// SPDX-License-Identifier: GPL-2.0-or-later
// Manual pages in the macros of man(7), and the references of docs/commands/ in Markdown. Both are made from the
// data of --help, so that they cannot differ.
#include <fmt/format.h>

#include "base/diagnostics/diagnostics.hpp"
#include "base/diagnostics/version.hpp"
#include "cli/commands.hpp"
#include "cli/exit_codes.hpp"
#include "cli/markdown.hpp"
#include "cli/option_list.hpp"
#include "cli/output_file.hpp"
#include "cli/usage.hpp"

namespace flatdyn {
namespace {

// The text escaped for roff, which neither sees a request at the beginning of a line nor breaks a word at a hyphen.
std::string roff(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const bool at_line_start = result.empty() || result.back() == '\n';
    if (at_line_start && (c == '.' || c == '\'')) result += "\\&";
    result += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
  }
  return result;
}

// The text with its line breaks kept.
std::string lines(const std::string& text) {
  std::string result;
  for (const char c : roff(text)) result += c == '\n' ? "\n.br\n" : std::string(1, c);
  return result;
}

std::string unfilled(const std::string& text) { return text.empty() ? "" : ".nf\n" + roff(text) + "\n.fi\n"; }

std::string section(const std::string& title, const std::string& body) {
  return body.empty() ? "" : ".SH " + title + "\n" + body;
}

std::string option_rows(const CLI::App& command) {
  std::string rows;
  for (const ListedOption& option : listed_options(command)) {
    std::string names;
    for (const std::string& name : option.names) names += (names.empty() ? "" : ", ") + name;
    const std::string value = option.value.empty() ? "" : " \\fI" + roff(option.value) + "\\fR";
    const std::string standard = option.standard.empty() ? "" : " (default: " + option.standard + ")";
    rows += fmt::format(".TP\n\\fB{}\\fR{}\n{}{}\n", roff(names), value, lines(option.meaning), roff(standard));
  }
  return rows;
}

std::string head(const std::string& name, const std::string& summary) {
  const std::string full_stop_dropped = summary.substr(0, summary.find_last_not_of('.') + 1);
  return fmt::format(".TH {} 1 \"\" \"flatdyn {}\" \"flatdyn\"\n", roff(name), kProgramVersion) +
         section("NAME", roff(name) + " \\- " + roff(full_stop_dropped) + "\n");
}

std::string exit_status() { return section("EXIT STATUS", roff(exit_codes_text()) + ".\n"); }

std::string page_of_command(const CLI::App& command) {
  const Description about = description_of(command);
  std::string usage = fmt::format("\\fBflatdyn {}\\fR [\\fIOPTIONS\\fR]", roff(command.get_name()));
  for (const CLI::Option* argument : positionals(command)) {
    const std::string name = "\\fI" + roff(argument->get_name(true)) + "\\fR";
    usage += argument->get_required() ? " " + name : " [" + name + "]";
  }
  return head("flatdyn-" + command.get_name(), about.first) + section("SYNOPSIS", usage + "\n") +
         section("DESCRIPTION", roff(about.text) + "\n") + section("EXAMPLES", unfilled(about.examples)) +
         section("OPTIONS", option_rows(command)) + section("NOTES", unfilled(command.get_footer())) + exit_status() +
         section("SEE ALSO", "\\fBflatdyn\\fR(1)\n");
}

std::string page_of_program(const CLI::App& app) {
  std::string rows, pages;
  for (const CLI::App* command : subcommands(app)) {
    const std::string name = roff(command->get_name());
    rows += fmt::format(".TP\n\\fB{}\\fR\n{}\n", name, roff(description_of(*command).first));
    pages += fmt::format("{}\\fBflatdyn\\-{}\\fR(1)", pages.empty() ? "" : ",\n", name);
  }
  const Description about = description_of(app);
  return head("flatdyn", about.first) + section("SYNOPSIS", "\\fBflatdyn\\fR \\fICOMMAND\\fR [\\fIOPTIONS\\fR]\n") +
         section("DESCRIPTION", roff(about.first) + "\n") + section("EXAMPLES", unfilled(about.examples)) +
         section("COMMANDS", rows) + exit_status() + section("SEE ALSO", pages + "\n");
}

struct ManArguments {
  std::string subcommand, folder;
  bool is_markdown = false;
};

ExitCode print_page(const CLI::App& app, const ManArguments& arguments) {
  const std::string& name = arguments.subcommand;
  if (name.empty()) {
    print_result(arguments.is_markdown ? markdown_of_program(app) : page_of_program(app));
  } else {
    const CLI::App& command = subcommand_named(app, name);
    print_result(arguments.is_markdown ? markdown_of_command(command) : page_of_command(command));
  }
  return ExitCode::ok;
}

ExitCode write_pages(const CLI::App& app, const ManArguments& arguments) {
  if (!arguments.subcommand.empty() || arguments.is_markdown) {
    throw Failure(FailureKind::usage, "-o FOLDER: it gets the manual pages of all subcommands",
                  "leave the other arguments out, or write -o - for one page on stdout");
  }
  const std::filesystem::path folder = arguments.folder;
  std::vector<TextFile> files = {{folder / "flatdyn.1", page_of_program(app)}};
  for (const CLI::App* command : subcommands(app)) {
    files.push_back({folder / ("flatdyn-" + command->get_name() + ".1"), page_of_command(*command)});
  }
  write_files(files);
  return ExitCode::ok;
}

}  // namespace

Run add_man(CLI::App& app) {
  auto* command = app.add_subcommand("man",
                                     "Print the manual page of the program, or of a subcommand, for man(1).\n\n"
                                     "  flatdyn man generate | man -l -\n"
                                     "  flatdyn man -o share/man/man1/");
  const auto arguments = std::make_shared<ManArguments>();
  command->add_option("subcommand", arguments->subcommand, "whose page; default: the program's")->type_name("COMMAND");
  command
      ->add_option("-o,--output", arguments->folder,
                   "write all pages to this folder, made if it is not there; - prints the one page, as without -o")
      ->check(kNotEmpty)
      ->type_name("FOLDER");
  command->add_flag("--markdown", arguments->is_markdown, "print the reference of docs/commands/ instead, in Markdown");
  return [&app, arguments] {
    const bool is_printed = arguments->folder.empty() || arguments->folder == kStdout;
    return is_printed ? print_page(app, *arguments) : write_pages(app, *arguments);
  };
}

}  // namespace flatdyn
