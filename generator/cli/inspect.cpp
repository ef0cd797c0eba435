// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include "cli/commands.hpp"
#include "proof/verify/rounded_angles.hpp"
#include "proof/verify/snap_effect.hpp"
#include "report/base_report.hpp"
#include "report/describe.hpp"
#include "report/json_text.hpp"
#include "report/links_in_file.hpp"
#include "report/places_in_file.hpp"

namespace flatdyn {
namespace {

struct InspectArguments : RobotArguments {
  bool base_parameters = false;
  std::string parameters = "given";
  std::string frames = "file";
};

ExitCode inspect(const InspectArguments& arguments) {
  const PipelineOptions options = arguments.options();
  const LoadedRobot model = load_robot(arguments.robot, options);
  Diagnostics findings = model.diagnostics;
  note_rounded_angles(model, options, {}, findings);
  print_diagnostics(findings, arguments);
  const ParameterSet set = parameter_set(arguments.parameters);
  const ParameterFrames frames = parameter_frames(arguments.frames);
  const SnapEffects effects = snap_effects(model, options.read);
  if (arguments.json) {
    nlohmann::ordered_json json = model_json(model, effects);
    json.update(links_json(model));
    if (arguments.verbose) json["places"] = places_json(model.robot);
    if (arguments.base_parameters) json.update(base_json(model.mechanism, set, frames));
    print_result(json_text(json));
  } else if (arguments.base_parameters) {
    print_result(describe_model(model, effects, SnapDetail::each) + "\n" + describe_bodies(model.mechanism, frames) +
                 "\n" + describe_base(model.mechanism, set, frames));
  } else {
    print_result(describe_model(model, effects, SnapDetail::each) + "\n" + describe_links(model) +
                 (arguments.verbose ? "\n" + describe_places(model.robot) : ""));
  }
  return ExitCode::ok;
}

}  // namespace

Run add_inspect(CLI::App& app) {
  auto* command =
      app.add_subcommand("inspect",
                         "Print the robot as understood: joints in the order of q, links, inertias, motors.\n\n"
                         "  flatdyn inspect robots/panda.urdf\n"
                         "  flatdyn inspect robots/planar_2r.toml --base-parameters --parameters nonzero");
  const auto arguments = std::make_shared<InspectArguments>();
  arguments->add_to(*command);
  command->add_flag("--base-parameters", arguments->base_parameters,
                    "print the fewest parameters that the torques depend on, and those that they do not depend on");
  add_parameters_option(*command, arguments->parameters, "for --base-parameters: ");
  add_frames_option(*command, arguments->frames);
  return [arguments] { return inspect(*arguments); };
}

}  // namespace flatdyn
