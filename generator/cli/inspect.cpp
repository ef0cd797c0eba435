// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include "cli/commands.hpp"
#include "report/describe.hpp"
#include "verify/snap_effect.hpp"

namespace flatdyn {
namespace {

ExitCode inspect(const RobotArguments& arguments) {
  const Model model = read_model(arguments.robot, arguments.options());
  print_diagnostics(model.diagnostics, arguments.quiet);
  const std::vector<double> effects = snap_effects(model, arguments.options().read);
  if (arguments.json) {
    fmt::print("{}\n", model_json(model, effects).dump(2));
  } else {
    fmt::print("{}\n{}", describe_model(model, effects), describe_bodies(model.mechanism));
  }
  return ExitCode::ok;
}

}  // namespace

Run add_inspect(CLI::App& app) {
  auto* command =
      app.add_subcommand("inspect",
                         "Print the robot as understood: joints in the order of q, frames, inertias, motors.\n\n"
                         "  flatdyn inspect robots/panda.urdf\n"
                         "  flatdyn inspect robots/planar_2r.toml --json");
  const auto arguments = std::make_shared<RobotArguments>();
  arguments->add_to(*command);
  return [arguments] { return inspect(*arguments); };
}

}  // namespace flatdyn
