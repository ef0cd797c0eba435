// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <chrono>

#include "base/system/interrupt.hpp"
#include "cli/commands.hpp"
#include "cli/output_file.hpp"
#include "report/simulation_report.hpp"

namespace flatdyn {
namespace {

struct SimulateArguments : RobotArguments {
  const CLI::Option *tolerance_given = nullptr, *step_given = nullptr;
  std::string simulation, output, events, plot, method = "adaptive";
  double duration = 0, rate = 0, tolerance = 1e-9, step = 1e-3;  // duration, rate: 0 if not given
};

constexpr double kMostRows = 1e7;

Simulation read(const SimulateArguments& arguments, const LoadedRobot& model) {
  Simulation simulation = resting(model.robot, model.mechanism);
  Diagnostics found;
  if (!arguments.simulation.empty()) {
    read_simulation(arguments.simulation, model.robot, model.mechanism, simulation, found);
  }
  arguments.report(found);
  if (arguments.duration > 0) simulation.duration = arguments.duration;
  if (arguments.rate > 0) simulation.rate = arguments.rate;
  if (simulation.duration * simulation.rate > kMostRows) {
    throw Failure(FailureKind::usage, fmt::format("{:g} rows are too many", simulation.duration * simulation.rate),
                  "a result has at most ten million: lower --rate or --duration");
  }
  simulation.method = arguments.method == "rk4" ? IntegrationMethod::rk4 : IntegrationMethod::adaptive;
  simulation.tolerance = arguments.tolerance;
  simulation.step = arguments.step;
  return simulation;
}

// Refuses options of the other method, which would have no effect.
void check_method(const SimulateArguments& arguments) {
  const bool is_rk4 = arguments.method == "rk4";
  if ((is_rk4 ? arguments.tolerance_given : arguments.step_given)->count() == 0) return;
  throw Failure(FailureKind::usage,
                fmt::format("--{} has no effect with --method {}", is_rk4 ? "tolerance" : "step", arguments.method),
                is_rk4 ? "give --step, or leave out --method rk4" : "give --tolerance, or --method rk4");
}

ExitCode run_simulate(const SimulateArguments& arguments) {
  check_method(arguments);
  const Interruption interruption;  // Ctrl-C ends the simulation and not the program: the motion so far is written
  const LoadedRobot model = load_robot(arguments.robot, arguments.options_without_error_budget());
  print_diagnostics(model.diagnostics, arguments);
  arguments.note_function_keys(model);
  const Simulation simulation = read(arguments, model);
  std::vector<std::string> inputs = model.robot.files;
  inputs.insert(inputs.end(), simulation.files.begin(), simulation.files.end());
  check_outputs({arguments.output, arguments.events, arguments.plot}, inputs);
  Progress progress(arguments.quiet);
  JointDynamics dynamics(model, progress);
  const auto start = std::chrono::steady_clock::now();
  const SimulatedMotion motion = simulate(simulation, dynamics, [&](double time) {
    progress.step(fmt::format("simulating: {:.1f} of {} s", time, simulation.duration));
    return Interruption::happened();
  });
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const TimeTable table = simulation_table(model.mechanism, motion);
  std::vector<TextFile> files = {{arguments.output, csv_text(table)}};
  if (!arguments.events.empty()) files.push_back({arguments.events, events_csv(model.mechanism, motion)});
  if (!arguments.plot.empty()) {
    files.push_back({arguments.plot, simulation_plot(model.mechanism, table, picture_format(arguments.plot))});
  }
  write_and_print(
      files, {describe_simulation(model.mechanism, motion, seconds), simulation_json(model.mechanism, motion, seconds)},
      arguments);
  if (!motion.interrupted) return ExitCode::ok;
  throw Failure(FailureKind::interrupted, fmt::format("interrupted at t = {} s", motion.end),
                "what was done until then is in " + arguments.output);
}

void add_integration_options(CLI::App& command, SimulateArguments& arguments) {
  command.add_option("--duration", arguments.duration, "of the motion; else the file's, or 10")
      ->type_name("S")
      ->check(positive_number());
  command.add_option("--rate", arguments.rate, "rows per second; else the file's, or 1000")
      ->type_name("HZ")
      ->check(positive_number());
  command.add_option("--method", arguments.method, "steps as the tolerance lets them be, or all of one length")
      ->capture_default_str()
      ->check(CLI::IsMember({"adaptive", "rk4"}));
  arguments.tolerance_given =
      command.add_option("--tolerance", arguments.tolerance, "adaptive: of positions and speeds in a step")
          ->capture_default_str()
          ->check(number_between(1e-14, 0.1));
  arguments.step_given = command.add_option("--step", arguments.step, "rk4: longest step; rows fall on steps")
                             ->capture_default_str()
                             ->type_name("S")
                             ->check(number_between(1e-7, 1.0));
}

}  // namespace

Run add_simulate(CLI::App& app) {
  auto* command = app.add_subcommand(
      "simulate",
      "Move the robot under given torques: forward dynamics (7.125), with dry friction and joint limits.\n\n"
      "  flatdyn simulate robots/planar_2r_example_7_2.toml -o fall.csv --plot fall.svg\n"
      "  flatdyn simulate robots/panda.urdf --simulation docs/examples/panda_reach.toml -o reach.csv");
  const auto arguments = std::make_shared<SimulateArguments>();
  arguments->add_to(*command);
  command
      ->add_option("--simulation", arguments->simulation,
                   "start, torques or control law, limits: docs/simulation-format.md; without it: a fall from rest")
      ->check(kNotEmpty)
      ->type_name("FILE");
  command->add_option("-o,--output", arguments->output, "the motion as CSV")
      ->required()
      ->check(kNotEmpty)
      ->type_name("FILE");
  command->add_option("--events", arguments->events, "when joints rest, slide, and meet limits, as CSV")
      ->check(kNotEmpty)
      ->type_name("FILE");
  add_plot_option(*command, arguments->plot, "positions, speeds, torques and energies");
  add_integration_options(*command, *arguments);
  return [arguments] { return run_simulate(*arguments); };
}

}  // namespace flatdyn
