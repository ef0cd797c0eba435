// SPDX-License-Identifier: GPL-2.0-or-later
// Options → pipeline → exit code.
#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "base/diagnostics/version.hpp"
#include "cli/commands.hpp"
#include "cli/exit_codes.hpp"
#include "cli/help.hpp"
#include "cli/usage.hpp"
#include "code/languages/language_table.hpp"

namespace flatdyn {
namespace {

// Checks that stdout has taken everything: printed text may wait in a buffer for a full disk or a closed pipe.
void check_stdout_is_open() {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return;
  throw Failure(FailureKind::io, std::string("standard output: cannot be written: ") + std::strerror(errno));
}

// Runs a command. Exceptions that end the run pass through.
ExitCode run(const Run& command) {
  const ExitCode code = command();
  check_stdout_is_open();
  return code;
}

ExitCode run(const Run& command, const OutputStyle& style) {
  prepare_for_interruption(style);
  try {
    return run(command);
  } catch (const BadInput& bad) {
    return report_failure(bad, style);
  } catch (const Failure& failure) {
    return report_failure(failure, style);
  } catch (const std::filesystem::filesystem_error& error) {
    return report_failure(Failure(FailureKind::io, error.what()), style);
  } catch (const std::system_error& error) {
    return report_failure(Failure(FailureKind::io, std::string("standard output: ") + error.what()), {});
  } catch (const std::exception& error) {
    return report_failure(Failure(FailureKind::bug, std::string("internal error: ") + error.what(),
                                  "please report it with the robot file"),
                          style);
  }
}

}  // namespace
}  // namespace flatdyn

int main(int argc, char** argv) {
  using namespace flatdyn;
  CLI::App app{"Flat, dependency-free " + languages_text() +
               " for the dynamics of one robot.\n\n"
               "  flatdyn generate robots/panda.urdf -o out/\n"
               "  flatdyn verify robots/panda.urdf\n\n"
               "Exit codes: " +
               exit_codes_text() + "."};
  app.name("flatdyn");
  app.formatter(std::make_shared<NarrowHelp>());
  app.set_version_flag("--version", fmt::format("flatdyn {}", kProgramVersion));
  app.require_subcommand(1);
  Run chosen;
  for (const auto add :
       {add_generate, add_inspect, add_derive,   add_verify,         add_eval,   add_excite, add_identify, add_payload,
        add_torques,  add_scale,   add_simulate, add_manipulability, add_report, add_bench,  add_certify,  add_stress,
        add_convert,  add_help,    add_man,      add_completion}) {
    const Run command = add(app);
    app.get_subcommands({}).back()->callback([&chosen, command] { chosen = command; });
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
    return static_cast<int>(report_failure(usage_failure(app, error), output_style_of(argc, argv)));
  }
  return static_cast<int>(run(chosen, output_style_of(app)));
}
