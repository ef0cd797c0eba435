// SPDX-License-Identifier: GPL-2.0-or-later
// Options → pipeline → exit code.
#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <system_error>

#include "cli/commands.hpp"
#include "diagnostics/exit_codes.hpp"
#include "diagnostics/nearest.hpp"

namespace flatdyn {
namespace {

ExitCode report(const Failure& failure) {
  fmt::print(stderr, "flatdyn: {}\n", failure.what());
  if (!failure.hint().empty()) fmt::print(stderr, "    hint: {}\n", failure.hint());
  return failure.code();
}

// What was printed may still wait in the buffer, for a disk that is full or a pipe that nobody reads.
void check_stdout() {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return;
  throw Failure(ExitCode::io, std::string("standard output: cannot be written: ") + std::strerror(errno));
}

ExitCode run(const Run& command) {
  try {
    const ExitCode code = command();
    check_stdout();
    return code;
  } catch (const BadInput& bad) {
    print_diagnostics(bad.diagnostics, false);
    if (!bad.diagnostics.has_errors()) fmt::print(stderr, "flatdyn: warnings are errors (-Werror)\n");
    return bad.code();
  } catch (const Failure& failure) {
    return report(failure);
  } catch (const std::system_error& error) {
    return report(Failure(ExitCode::io, std::string("standard output: ") + error.what()));
  } catch (const std::exception& error) {
    fmt::print(stderr, "flatdyn: internal error: {}\n    hint: please report it with the robot file\n", error.what());
    return ExitCode::bug;
  }
}

// CLI11 only says that a subcommand is needed.
void check_subcommand(const CLI::App& app, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(command->get_name());
  }
  if (word.empty() || word.front() == '-' || std::find(names.begin(), names.end(), word) != names.end()) return;
  throw Failure(ExitCode::usage, "there is no subcommand \"" + word + "\"",
                hint_for_unknown(word, names, "subcommands"));
}

}  // namespace
}  // namespace flatdyn

int main(int argc, char** argv) {
  using namespace flatdyn;
  CLI::App app{
      "Flat, dependency-free C++ for the dynamics of one robot.\n\n"
      "  flatdyn generate robots/panda.urdf -o out/\n"
      "  flatdyn verify robots/panda.urdf\n\n"
      "Exit codes: " +
      exit_codes_text() + "."};
  app.name("flatdyn");
  app.set_version_flag("--version", "flatdyn " FLATDYN_VERSION);
  app.require_subcommand(1);
  Run chosen;
  for (const auto add : {add_generate, add_inspect, add_derive, add_verify, add_eval, add_excite, add_identify,
                         add_payload, add_torques, add_scale, add_simulate, add_manipulability, add_report, add_bench,
                         add_certify, add_stress, add_man, add_completion}) {
    const Run command = add(app);
    app.get_subcommands({}).back()->callback([&chosen, command] { chosen = command; });
  }
  try {
    check_subcommand(app, argc > 1 ? argv[1] : "");
    app.parse(argc, argv);
  } catch (const Failure& failure) {
    return static_cast<int>(report(failure));
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : static_cast<int>(ExitCode::usage);
  }
  return static_cast<int>(run(chosen));
}
