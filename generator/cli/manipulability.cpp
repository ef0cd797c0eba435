// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <map>

#include "cli/commands.hpp"
#include "cli/output_file.hpp"
#include "report/manipulability_report.hpp"
#include "report/time_table.hpp"
#include "verify/csv.hpp"

namespace flatdyn {
namespace {

struct ManipulabilityArguments : RobotArguments {
  std::string states, output, plot, plane, norm = "plain";
  double torque = 1;
};

std::vector<std::vector<double>> read_positions(const std::string& file, const Mechanism& mechanism) {
  Diagnostics found;
  const CsvTable table = read_csv(file, found);
  const std::vector<std::size_t> columns = joint_columns(table, "q", mechanism, file, found);
  if (table.rows.empty()) found.error({file, 0}, "there is no row", "write a heading and at least one position");
  if (found.has_errors()) throw BadInput(ExitCode::input, found);
  std::vector<std::vector<double>> positions;
  for (const std::vector<std::string>& row : table.rows) {
    positions.emplace_back();
    for (const std::size_t column : columns) positions.back().push_back(nearest_double(exact_decimal(row[column])));
  }
  return positions;
}

// The one asked for; else one in which an arm of a plane moves, else the one from the side.
DrawingPlane drawing_plane(const std::string& name, const std::vector<int>& task) {
  static const std::map<std::string, DrawingPlane> kPlanes = {{"xy", {0, 1}}, {"xz", {0, 2}}, {"yz", {1, 2}}};
  if (!name.empty()) return kPlanes.at(name);
  if (task == std::vector{0, 1}) return {0, 1};
  return task == std::vector{1, 2} ? DrawingPlane{1, 2} : DrawingPlane{0, 2};
}

ExitCode run_manipulability(const ManipulabilityArguments& arguments) {
  const Model model = read_model(arguments.robot, arguments.options_of_whole_functions());
  refuse_loops(model, "manipulability");
  print_diagnostics(model.diagnostics, arguments.quiet);
  arguments.note_function_keys(model);
  std::vector<std::string> inputs = model.robot.files;
  inputs.push_back(arguments.states);
  check_outputs({arguments.output, arguments.plot}, inputs);
  const std::vector<std::vector<double>> positions = read_positions(arguments.states, model.mechanism);
  Progress progress(arguments.quiet);
  Manipulability arm(model, arguments.norm == "limits" ? TorqueNorm::limits : TorqueNorm::plain, arguments.torque,
                     progress);
  std::vector<ManipulablePose> poses;
  for (const std::vector<double>& q : positions) poses.push_back({q, arm.at(q), arm.skeleton(q)});
  std::vector<TextFile> files;
  if (!arguments.output.empty()) files.push_back({arguments.output, manipulability_csv(arm.task(), poses)});
  if (!arguments.plot.empty()) {
    const DrawingPlane plane = drawing_plane(arguments.plane, arm.task());
    files.push_back({arguments.plot, manipulability_plot(model.mechanism.name, arm.task(), poses, plane,
                                                         picture_format(arguments.plot))});
  }
  write_and_tell(
      files, {describe_manipulability(arm.task(), poses), manipulability_json(model.mechanism.name, arm.task(), poses)},
      arguments.json);
  return ExitCode::ok;
}

}  // namespace

Run add_manipulability(CLI::App& app) {
  auto* command = app.add_subcommand(
      "manipulability",
      "The dynamic manipulability ellipsoid (7.148) at positions of a CSV file: which accelerations of the tip torques "
      "of one norm make.\n\n"
      "  flatdyn manipulability robots/planar_2r_example_7_2.toml --states docs/examples/two_poses.csv --torque 500\n"
      "  flatdyn manipulability robots/panda.urdf --states docs/examples/panda_states.csv --norm limits -o m.csv");
  const auto arguments = std::make_shared<ManipulabilityArguments>();
  arguments->add_to(*command);
  command->add_option("--states", arguments->states, "CSV: q1,… or q_<joint>,…; other columns do not matter")
      ->required()
      ->check(kNotEmpty)
      ->type_name("FILE");
  command->add_option("--norm", arguments->norm, "of the torques: all together, or each as a part of its joint's limit")
      ->capture_default_str()
      ->check(CLI::IsMember({"plain", "limits"}));
  command->add_option("--torque", arguments->torque, "the norm: N m, or parts of the limits")
      ->capture_default_str()
      ->check(positive_number());
  command->add_option("-o,--output", arguments->output, "centres, half axes and measures as CSV")
      ->check(kNotEmpty)
      ->type_name("FILE");
  add_plot_option(*command, arguments->plot, "the arm with its ellipsoids");
  command
      ->add_option("--plane", arguments->plane, "that the picture shows, of the base frame; default: the arm's, or xz")
      ->check(CLI::IsMember({"xy", "xz", "yz"}));
  return [arguments] { return run_manipulability(*arguments); };
}

}  // namespace flatdyn
