// SPDX-License-Identifier: GPL-2.0-or-later
// Options → pipeline → exit code.
#include <fmt/format.h>

#include "cli/commands.hpp"

namespace flatdyn {
namespace {

ExitCode report(const Failure& failure) {
  fmt::print(stderr, "flatdyn: {}\n", failure.what());
  if (!failure.hint().empty()) fmt::print(stderr, "    hint: {}\n", failure.hint());
  return failure.code();
}

ExitCode run(const Run& command) {
  try {
    return command();
  } catch (const BadInput& bad) {
    print_diagnostics(bad.diagnostics, false);
    if (!bad.diagnostics.has_errors()) fmt::print(stderr, "flatdyn: warnings are errors (-Werror)\n");
    return bad.code();
  } catch (const Failure& failure) {
    return report(failure);
  } catch (const std::exception& error) {
    fmt::print(stderr, "flatdyn: internal error: {}\n    hint: please report it with the robot file\n", error.what());
    return ExitCode::bug;
  }
}

}  // namespace
}  // namespace flatdyn

int main(int argc, char** argv) {
  using namespace flatdyn;
  CLI::App app{
      "Flat, dependency-free C++ for the dynamics of one robot.\n\n"
      "  flatdyn generate robots/panda.urdf -o out/\n"
      "  flatdyn verify robots/panda.urdf\n\n"
      "Exit codes: 0 ok, 1 bug, 2 usage, 3 input, 4 unsupported, 5 verification failed, 6 I/O."};
  app.name("flatdyn");
  app.set_version_flag("--version", "flatdyn " FLATDYN_VERSION);
  app.require_subcommand(1);
  Run chosen;
  for (const auto add : {add_generate, add_inspect, add_derive, add_verify, add_eval, add_excite}) {
    const Run command = add(app);
    app.get_subcommands({}).back()->callback([&chosen, command] { chosen = command; });
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : static_cast<int>(ExitCode::usage);
  }
  return static_cast<int>(run(chosen));
}
