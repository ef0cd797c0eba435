// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "cli/commands.hpp"
#include "cli/output_file.hpp"
#include "laboratory/manipulability/workspace_map.hpp"
#include "report/manipulability_plot.hpp"
#include "report/plot/time_table.hpp"
#include "robot/input/csv/base_gravity.hpp"
#include "robot/input/csv/positions.hpp"

namespace flatdyn {
namespace {

struct ManipulabilityArguments : RobotArguments {
  std::string states, output, plot, view, map, norm = "plain";
  double torque = 1, spacing = 0;
};

// The names of --norm.
const std::map<std::string, TorqueBall> kTorques = {
    {"plain", {TorqueNorm::plain, 1, TorqueSet::least_accelerations}},
    {"limits", {TorqueNorm::limits, 1, TorqueSet::least_accelerations}},
    {"torque", {TorqueNorm::plain, 1, TorqueSet::all}},
    {"torque-limits", {TorqueNorm::limits, 1, TorqueSet::all}},
};

TorqueBall torques_of(const ManipulabilityArguments& arguments) {
  TorqueBall torques = kTorques.at(arguments.norm);
  torques.radius = arguments.torque;
  return torques;
}

constexpr double kPlacesAlongArm = 24;  // in a map without --spacing

struct Positions {
  std::vector<std::vector<double>> q;
  std::vector<Eigen::Vector3d> g_b;  // gravity in the axes of a floating base, one per row of q; else empty
  std::vector<double> t;             // empty, or one time per row of q
  int first_line = 0;                // line of the first row in the file

  std::optional<Eigen::Vector3d> gravity(std::size_t row) const {
    return g_b.empty() ? std::nullopt : std::optional(g_b[row]);
  }
};

// The columns that are read.
struct PositionColumns {
  std::vector<CsvSource> q;
  std::optional<BaseGravity> gravity;  // of a floating base
  std::optional<CsvTime> time;

  std::vector<CsvSource> sources() const {
    std::vector<CsvSource> all = q;
    if (!gravity) return all;
    for (const CsvSource& source : gravity->sources()) all.push_back(source);
    return all;
  }
};

PositionColumns columns_of(CsvHeading& heading, const Mechanism& mechanism, const Place& place, Diagnostics& found) {
  PositionColumns columns;
  columns.q = heading.require(CsvQuantity::q, "positions");
  if (mechanism.has_base_gravity()) {
    columns.gravity.emplace(heading, mechanism, place, "gravity shifts the ellipsoids", found);
  }
  columns.time = heading.find_time();
  heading.finish();
  return columns;
}

Positions read_positions(const ManipulabilityArguments& arguments, const Mechanism& mechanism) {
  const std::string& file = arguments.states;
  Diagnostics found;
  CsvTable table = read_csv(file, found);
  CsvHeading heading = table.heading(file, mechanism, found);
  const PositionColumns columns = columns_of(heading, mechanism, {file, table.heading_line}, found);
  check_entries(table, columns.sources(), heading, file, found);
  if (table.rows.empty()) found.error({file, 0}, "there is no row", "write a heading and at least one position");
  if (!arguments.map.empty() && table.rows.size() > 1) {
    found.error({file, table.lines[1]}, "a map starts at one position", "leave one row, or leave out --map");
  }
  Positions positions;
  if (columns.time) positions.t = times_of(table, *columns.time, file, found);
  arguments.report(found);
  Diagnostics asked;
  warn_of_positions(table, {columns.q.begin(), columns.q.end()}, mechanism, file, asked);
  if (columns.gravity) columns.gravity->check(table, file, asked);
  arguments.report(asked);
  positions.first_line = table.lines.front();
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    positions.q.emplace_back();
    for (const CsvSource& source : columns.q)
      positions.q.back().push_back(nearest_double(exact_value(table, row, source)));
    if (!mechanism.floating_base) continue;
    positions.g_b.push_back(columns.gravity ? Eigen::Vector3d(columns.gravity->at(table, row).data())
                                            : Eigen::Vector3d::Zero());
  }
  return positions;
}

// The views asked for; by default the plane in which a planar arm moves, or all.
std::vector<View> views(const std::string& name, const std::vector<int>& task) {
  if (!name.empty() && name != "all") return {view_of(name)};
  if (name.empty() && task == std::vector{0, 1}) return {view_of("xy")};
  if (name.empty() && task == std::vector{0, 2}) return {view_of("xz")};
  if (name.empty() && task == std::vector{1, 2}) return {view_of("yz")};
  return all_views();
}

bool has_turns(const std::vector<int>& task) {
  return std::any_of(task.begin(), task.end(), [](int row) { return row >= 3; });
}

// Replaces the start by all places on a grid that the tip can reach from there. With a floating base they are seen from
// it, so it counts as fixed, and as turned as it is at the start.
void spread(const ManipulabilityArguments& arguments, const LoadedRobot& model, const std::vector<int>& task,
            double spacing, Positions& positions) {
  const Eigen::VectorXd start = Eigen::VectorXd::Map(positions.q.front().data(), model.mechanism.position_count());
  if (!is_within_limits(model.mechanism, start)) {
    Diagnostics found;
    found.error({arguments.states, positions.first_line}, "the map's start is beyond the joints' limits",
                "start within them");
    throw BadInput(FailureKind::input, found);
  }
  WorkspaceGrid grid{view_of(arguments.map).onto.transpose(), spacing, has_turns(task)};
  Robot held = model.robot;
  held.floating_base = false;
  const std::optional<Eigen::Vector3d> g_b = positions.gravity(0);
  positions = {};
  for (const Eigen::VectorXd& q : map_workspace(TipKinematics(held), model.mechanism, start, grid)) {
    positions.q.emplace_back(q.begin(), q.end());
    if (g_b) positions.g_b.push_back(*g_b);
  }
}

std::string picture(const ManipulabilityArguments& arguments, const std::string& robot, const std::vector<int>& task,
                    const std::vector<ManipulablePose>& poses, double spacing) {
  const PictureFormat format = picture_format(arguments.plot);
  if (!arguments.map.empty()) return workspace_plot(robot, task, poses, view_of(arguments.map), spacing, format);
  return manipulability_plot(robot, task, poses, views(arguments.view, task), format);
}

void note_contacts(const ManipulabilityArguments& arguments, const LoadedRobot& model) {
  if (model.mechanism.contacts.empty()) return;
  Diagnostics notes;
  notes.note({model.robot.scene.file, 0},
             "contacts have no effect here: ellipsoids are those of a robot that touches nothing",
             "constrained_forward_dynamics of eval has accelerations with contacts");
  arguments.report(notes);
}

std::vector<ManipulablePose> poses_at(const Positions& positions, Manipulability& arm) {
  std::vector<ManipulablePose> poses;
  for (std::size_t k = 0; k < positions.q.size(); ++k) {
    const std::vector<double>& q = positions.q[k];
    const std::optional<Eigen::Vector3d> g_b = positions.gravity(k);
    poses.push_back({q, arm.at(q, g_b.value_or(Eigen::Vector3d::Zero())), arm.skeleton(q)});
    poses.back().g_b = g_b;
    if (!positions.t.empty()) poses.back().t = positions.t[k];
  }
  return poses;
}

ExitCode run_manipulability(const ManipulabilityArguments& arguments) {
  const LoadedRobot model = load_robot(arguments.robot, arguments.options_without_error_budget());
  refuse_loops(model, "manipulability");
  print_diagnostics(model.diagnostics, arguments);
  arguments.note_function_keys(model);
  note_contacts(arguments, model);
  std::vector<std::string> inputs = model.robot.files;
  inputs.push_back(arguments.states);
  check_outputs({arguments.output, arguments.plot}, inputs);
  Positions positions = read_positions(arguments, model.mechanism);
  Progress progress(arguments.quiet);
  Manipulability arm(model, torques_of(arguments), progress);
  const double length = length_of(arm.skeleton(positions.q.front()));
  const double spacing = arguments.spacing > 0 ? arguments.spacing : length / kPlacesAlongArm;
  if (!arguments.map.empty()) {
    progress.step("mapping the workspace");
    spread(arguments, model, arm.task(), spacing, positions);
  }
  const std::vector<ManipulablePose> poses = poses_at(positions, arm);
  const std::string& name = model.mechanism.name;
  std::vector<TextFile> files;
  if (!arguments.output.empty()) files.push_back({arguments.output, manipulability_csv(arm.task(), poses)});
  if (!arguments.plot.empty()) {
    files.push_back({arguments.plot, picture(arguments, name, arm.task(), poses, spacing)});
  }
  write_and_print(
      files, {describe_manipulability(arm.task(), poses), manipulability_json(name, arguments.norm, arm.task(), poses)},
      arguments);
  return ExitCode::ok;
}

}  // namespace

Run add_manipulability(CLI::App& app) {
  auto* command = app.add_subcommand(
      "manipulability",
      "The dynamic manipulability ellipsoid (7.148) at positions of a CSV file: which accelerations of the tip torques "
      "of one norm make. For a redundant arm --norm torque has those that any torques make. With a floating base they "
      "are those of joint torques alone, while nothing holds the base.\n\n"
      "  flatdyn manipulability robots/planar_2r_example_7_2.toml --states docs/examples/two_poses.csv --torque 500\n"
      "  flatdyn manipulability robots/panda.urdf --states docs/examples/panda_states.csv --norm limits -o m.csv\n"
      "  flatdyn manipulability robots/ur5.urdf --states start.csv --map xz --plot map.svg -o map.csv\n"
      "  flatdyn manipulability robots/panda.urdf --base floating --gravity off --states "
      "docs/examples/panda_states.csv");
  const auto arguments = std::make_shared<ManipulabilityArguments>();
  arguments->add_to(*command);
  command
      ->add_option(
          "--states", arguments->states,
          "CSV: q1,… or q_<joint>,…; with a floating base also gravity in its axes, base_gx to base_gz, or its "
          "quaternion, base_qw to base_qz; other columns do not matter")
      ->required()
      ->check(kNotEmpty)
      ->type_name("FILE");
  command
      ->add_option(
          "--norm", arguments->norm,
          "of the torques: all together, or each as a part of its joint's limit; torque and torque-limits: the "
          "same of all torques, J B^-1 tau, not only those of least joint accelerations as in (7.148)")
      ->capture_default_str()
      ->check(CLI::IsMember({"plain", "limits", "torque", "torque-limits"}));
  command->add_option("--torque", arguments->torque, "the norm: N m, or parts of the limits")
      ->capture_default_str()
      ->check(positive_number());
  command->add_option("-o,--output", arguments->output, "centres, half axes and measures as CSV")
      ->check(kNotEmpty)
      ->type_name("FILE");
  add_plot_option(*command, arguments->plot, "the arm with its ellipsoids");
  auto* view =
      command
          ->add_option("--view", arguments->view,
                       "of the picture: along an axis of the base frame, in space, or all of them; default: the arm's "
                       "plane, or all")
          ->check(CLI::IsMember({"xy", "xz", "yz", "space", "all"}));
  auto* map = command
                  ->add_option("--map", arguments->map,
                               "instead of the position in the file, all that the tip gets to from there in a plane of "
                               "the base frame")
                  ->check(CLI::IsMember({"xy", "xz", "yz"}))
                  ->excludes(view);
  command->add_option("--spacing", arguments->spacing, "of the map's places, m; default: a 24th of the arm's length")
      ->needs(map)
      ->check(positive_number());
  return [arguments] { return run_manipulability(*arguments); };
}

}  // namespace flatdyn
