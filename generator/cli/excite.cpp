// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include "base/system/interrupt.hpp"
#include "cli/commands.hpp"
#include "cli/output_file.hpp"
#include "report/controller_file.hpp"
#include "report/excitation_report.hpp"
#include "robot/model/identifiers.hpp"

namespace flatdyn {
namespace {

struct ExciteArguments : RobotArguments {
  std::string folder;
  std::vector<std::string> logs;
  std::string parameters = "given";
  std::string frames = "file";
  ExcitationOptions plan;
  std::optional<int> evaluations;
  std::optional<double> time;
  bool no_base_force = false;
  std::string imu;
  std::string controller;
  std::optional<double> rate;

  const ControllerRow* controller_row() const {
    return controller.empty() ? nullptr : &flatdyn::controller_row(controller);
  }
};

// The plan of the options. If the number of evaluations is given, the same motion is wanted on every machine, so the
// default time limit does not apply.
ExcitationOptions plan_of(const ExciteArguments& arguments) {
  ExcitationOptions plan = arguments.plan;
  if (arguments.evaluations) {
    plan.evaluations = *arguments.evaluations;
    plan.time.reset();
  }
  if (arguments.time) plan.time = arguments.time;
  const ControllerRow* controller = arguments.controller_row();
  if (controller != nullptr) plan.rate = controller->rate.value_or(plan.rate);
  if (arguments.rate) plan.rate = *arguments.rate;
  return plan;
}

// The information of the logs that are given.
std::optional<LoggedInformation> logged_already(const ExciteArguments& arguments, const TorqueModel& model,
                                                Progress& progress) {
  if (arguments.logs.empty()) return std::nullopt;
  Diagnostics found;
  LoggedInformation logged =
      logged_information(model, {arguments.logs.begin(), arguments.logs.end()}, arguments.imu, progress, found);
  arguments.report(found);
  return logged;
}

void check_controller(const ExciteArguments& arguments, const Mechanism& mechanism) {
  const ControllerRow* row = arguments.controller_row();
  if (row == nullptr) return;
  const bool is_plain = !mechanism.floating_base && mechanism.position_count() == mechanism.size();
  if (!is_plain || (row->joints && mechanism.size() != *row->joints)) {
    throw Failure(FailureKind::unsupported,
                  fmt::format("--controller {} is for robots with a fixed base and {} joints that move by themselves",
                              row->name, row->joints ? std::to_string(*row->joints) : "only"),
                  "hold other joints with --fix");
  }
  if (row->rate && arguments.rate && *row->rate != *arguments.rate) {
    throw Failure(FailureKind::usage, fmt::format("--controller {} takes {} samples a second", row->name, *row->rate),
                  "leave --rate out");
  }
}

ExitCode excite(const ExciteArguments& arguments) {
  const LoadedRobot model = load_robot(arguments.robot, arguments.options_without_error_budget());
  refuse_loops(model, "excite");
  if ((arguments.no_base_force || !arguments.imu.empty()) && !model.mechanism.floating_base) {
    throw Failure(FailureKind::usage, "--no-base-force and --imu are for robots with a floating base",
                  "give --base floating");
  }
  print_diagnostics(model.diagnostics, arguments);
  arguments.note_function_keys(model);
  const std::string name = cpp_identifier(model.mechanism.name);  // as for a generated header
  const std::filesystem::path stem = std::filesystem::path(arguments.folder) / (name + "_excitation");
  const ControllerRow* controller = arguments.controller_row();
  const std::string csv = stem.string() + ".csv", svg = stem.string() + ".svg",
                    program = controller != nullptr ? stem.string() + controller->suffix : "";
  check_controller(arguments, model.mechanism);
  std::vector<std::string> inputs = model.robot.files;
  inputs.insert(inputs.end(), arguments.logs.begin(), arguments.logs.end());
  check_outputs({csv, svg, program}, inputs);
  const Interruption interruption;  // Ctrl-C ends the search and not the program: the best motion so far is written
  Progress progress(arguments.quiet);
  const TorqueModel torques(model, parameter_set(arguments.parameters), progress);
  const std::optional<LoggedInformation> logged = logged_already(arguments, torques, progress);
  const MotionEquations equations(torques, !arguments.no_base_force);
  ExcitationOptions plan = plan_of(arguments);
  if (logged) plan.logged = logged->root;
  const Excitation excitation = make_excitation(equations, plan, progress, Interruption::happened);
  const ParameterFrames frames = parameter_frames(arguments.frames);
  std::vector<TextFile> files = {{csv, excitation_csv(equations, excitation.motion)},
                                 {svg, excitation_plot(equations, excitation.motion)}};
  if (controller != nullptr) files.push_back({program, controller_text(*controller, equations, excitation.motion)});
  write_and_print(files,
                  {describe_excitation(equations, excitation, logged, frames) + "\n",
                   excitation_json(equations, excitation, logged, frames)},
                  arguments);
  if (!Interruption::happened()) return ExitCode::ok;
  throw Failure(FailureKind::interrupted, "interrupted before the search was at its end",
                "the best motion so far, which keeps the limits, is in " + csv);
}

void add_plan_options(CLI::App& command, ExciteArguments& arguments) {
  ExcitationOptions& plan = arguments.plan;
  command.add_option("--duration", plan.duration, "of the motion, from rest to rest")
      ->capture_default_str()
      ->type_name("S")
      ->check(number_between(0.1, 3600.0));
  command.add_option("--rate", arguments.rate, "samples per second; default: those of --controller, or 100")
      ->type_name("HZ")
      ->check(number_between(1.0, 10000.0));
  command.add_option("--harmonics", plan.harmonics, "of every joint's Fourier series")
      ->capture_default_str()
      ->check(CLI::Range(1, 50));
  command.add_option("--margin", plan.margin, "the part of every limit that may be used")
      ->capture_default_str()
      ->check(number_between(0.01, 1.0));
  command.add_option("--seed", plan.seed, "of the random starts")->capture_default_str();
  command
      .add_option("--evaluations", arguments.evaluations,
                  "of the criterion; the search ends before that where it gets no better")
      ->default_str(fmt::format("{}", plan.evaluations))
      ->check(CLI::Range(1, 10000000));
  command
      .add_option("--time", arguments.time,
                  "ends the search earlier; the result then depends on the computer. Default: 30, or none with "
                  "--evaluations")
      ->type_name("S")
      ->check(number_between(0.001, 1e6));
}

}  // namespace

Run add_excite(CLI::App& app) {
  auto* command = app.add_subcommand(
      "excite",
      "Find a motion from which the dynamic parameters can be identified well, within the robot's limits.\n\n"
      "  flatdyn excite robots/planar_2r_example_7_2.toml -o out/\n"
      "  flatdyn excite robots/panda.urdf -o out/ --duration 30 --rate 50 --margin 0.7\n"
      "  flatdyn excite robots/panda.urdf -o out/ --data log.csv");
  const auto arguments = std::make_shared<ExciteArguments>();
  arguments->add_to(*command);
  command
      ->add_option("-o,--output", arguments->folder,
                   "folder for NAME_excitation.csv and NAME_excitation.svg; made if it is not there")
      ->required()
      ->check(folder_name())
      ->type_name("FOLDER");
  command
      ->add_option("--data", arguments->logs,
                   "logs of motion that was identified from already, as for identify: the new motion completes what "
                   "they tell, so that parameters that they leave open count most")
      ->type_name("LOG.csv");
  command->add_option("--imu", arguments->imu, "the link whose frame is that of the measurement unit in these logs")
      ->type_name("LINK");
  command
      ->add_option("--controller", arguments->controller,
                   "also a file that a controller takes: URScript with servoj() at 500 Hz (ur), positions at 1 kHz as "
                   "CSV (franka), or trajectory_msgs/JointTrajectory as JSON, which is YAML, too (ros)")
      ->check(CLI::IsMember(controller_names()));
  command->add_flag("--no-base-force", arguments->no_base_force,
                    "the force on a floating base will not be measured: parameters that it alone tells do not count");
  add_plan_options(*command, *arguments);
  add_parameters_option(*command, arguments->parameters, "what is to be identified: ");
  add_frames_option(*command, arguments->frames);
  return [arguments] { return excite(*arguments); };
}

}  // namespace flatdyn
