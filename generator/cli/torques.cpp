// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/output_file.hpp"
#include "laboratory/trajectory/closed_positions.hpp"
#include "laboratory/trajectory/read_trajectory.hpp"
#include "report/torque_report.hpp"

namespace flatdyn {
namespace {

struct TorquesArguments : RobotArguments {
  std::string trajectory, output, plot;
};

std::vector<TextFile> torque_files(const TorquesArguments& arguments, const LoadedRobot& model,
                                   const Trajectory& trajectory, const TorqueHistory& history) {
  const ByPoint q = positions_along(model, trajectory);
  std::vector<TextFile> files = {{arguments.output, csv_text(torque_table(trajectory, q, history))}};
  if (!arguments.plot.empty()) {
    files.push_back(
        {arguments.plot, torque_plot(model.mechanism, trajectory, q, history, picture_format(arguments.plot))});
  }
  return files;
}

ExitCode torques(const TorquesArguments& arguments) {
  const LoadedRobot model = load_robot(arguments.robot, arguments.options_without_error_budget());
  refuse_floating_base(model, "torques");
  refuse_spherical_joints(model, "torques");
  print_diagnostics(model.diagnostics, arguments);
  arguments.note_function_keys(model);
  std::vector<std::string> inputs = model.robot.files;
  inputs.push_back(arguments.trajectory);
  check_outputs({arguments.output, arguments.plot}, inputs);
  Diagnostics found;
  const Trajectory trajectory = read_trajectory(arguments.trajectory, model.robot, model.mechanism, found);
  arguments.report(found);
  TorqueHistory history;
  {
    Progress progress(arguments.quiet);
    TorqueTerms terms(model, trajectory.has_tip_force(), progress);
    history = torque_history(terms, trajectory);
  }
  arguments.report(exceeded_limits(model.mechanism, trajectory, history.tau, arguments.trajectory));
  write_and_print(torque_files(arguments, model, trajectory, history),
                  {describe_torques(model.mechanism, trajectory, history) + "\n",
                   torques_json(model.mechanism, trajectory, history)},
                  arguments);
  return ExitCode::ok;
}

}  // namespace

Run add_torques(CLI::App& app) {
  auto* command = app.add_subcommand(
      "torques",
      "Compute the torques that a motion needs, each contribution by itself.\n\n"
      "  flatdyn torques robots/planar_2r_example_7_2.toml --trajectory docs/examples/planar_2r_triangular.toml \\\n"
      "      -o out.csv --plot out.svg\n"
      "  flatdyn torques robots/panda.urdf --trajectory motion.csv -o out.csv --json");
  const auto arguments = std::make_shared<TorquesArguments>();
  arguments->add_to(*command);
  add_trajectory_option(*command, arguments->trajectory);
  command->add_option("-o,--output", arguments->output, "CSV: the motion, the torques, and every contribution")
      ->required()
      ->check(kNotEmpty)
      ->type_name("FILE.csv");
  add_plot_option(*command, arguments->plot, "positions, rates, accelerations, torques and what they are made of");
  return [arguments] { return torques(*arguments); };
}

}  // namespace flatdyn
