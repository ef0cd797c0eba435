// SPDX-License-Identifier: GPL-2.0-or-later
// `flatdyn help NAME`, which prints what `flatdyn NAME --help` does.
#include <fmt/format.h>

#include <memory>

#include "cli/commands.hpp"
#include "cli/output_file.hpp"
#include "cli/usage.hpp"

namespace flatdyn {
namespace {

std::string help_of(const CLI::App& command, const std::string& called) {
  return command.get_formatter()->make_help(&command, called, CLI::AppFormatMode::Normal);
}

}  // namespace

Run add_help(CLI::App& app) {
  auto* command = app.add_subcommand("help",
                                     "Print the help of the program, or of a subcommand, as --help does.\n\n"
                                     "  flatdyn help generate");
  const auto name = std::make_shared<std::string>();
  command->add_option("subcommand", *name, "whose help; default: the program's")->type_name("COMMAND");
  return [&app, name] {
    const std::string& called = app.get_name();
    print_result(name->empty() ? help_of(app, called) : help_of(subcommand_named(app, *name), called + " " + *name));
    return ExitCode::ok;
  };
}

}  // namespace flatdyn
