// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "cli/commands.hpp"
#include "cli/output_file.hpp"
#include "laboratory/identify/drive_gains.hpp"
#include "laboratory/identify/torque_equations.hpp"
#include "laboratory/identify/usable_samples.hpp"
#include "laboratory/identify/wrist.hpp"
#include "report/drive_gains_report.hpp"
#include "report/payload_report.hpp"

namespace flatdyn {
namespace {

struct PayloadArguments : RobotArguments {
  std::vector<std::string> logs, without;
  std::string output;
  std::string parameters;
  bool wrist = false;
  std::optional<double> known_mass;  // kg
  StreamOptions stream;
};

void check_payload_usage(const PayloadArguments& arguments, const LoadedRobot& robot) {
  if (arguments.wrist && !arguments.without.empty()) {
    throw Failure(FailureKind::usage, "--wrist and --without exclude each other",
                  "a sensor at the wrist measures the payload alone");
  }
  if (arguments.known_mass && arguments.without.empty()) {
    throw Failure(FailureKind::usage, "--known-mass needs --without LOG.csv",
                  "motion with and without the payload tells the gains of the drives");
  }
  check_imu(robot.mechanism, arguments.stream.imu);
  std::vector<std::string> inputs = robot.robot.files;
  inputs.insert(inputs.end(), arguments.logs.begin(), arguments.logs.end());
  inputs.insert(inputs.end(), arguments.without.begin(), arguments.without.end());
  check_outputs({arguments.output}, inputs);
  check_other_logs(arguments.logs, arguments.without, "--without");
  if (robot.robot.has_payload) {
    throw Failure(FailureKind::unsupported, fmt::format("{}: the robot has a payload already", robot.robot.file),
                  "take it out of the file: the one that is found takes its place");
  }
}

Measurement observed(const EquationModel& equations, const LoadedRobot& robot, const std::vector<std::string>& logs,
                     const PayloadArguments& arguments, Progress& progress) {
  Diagnostics found;
  StreamOptions options = arguments.stream;
  options.torques = !arguments.wrist;
  Measurement measurement = measure(equations, robot.mechanism, {logs.begin(), logs.end()}, options, progress, found);
  if (!found.has_errors() && arguments.wrist) check_used_samples(measurement, logs.front(), found);
  if (!found.has_errors() && !arguments.wrist) check_samples(measurement, robot.mechanism, logs.front(), found);
  arguments.report(found);
  return measurement;
}

// The payload as the change of the last link against the log without payload, or against the robot file.
FittedPayload from_torques(const LoadedRobot& robot, const PayloadArguments& arguments, Progress& progress) {
  const TorqueModel model(robot, parameter_set(arguments.parameters, robot.mechanism), progress);
  const TorqueEquations equations(model);
  std::vector<Measurement> measurements = {observed(equations, robot, arguments.logs, arguments, progress)};
  if (!arguments.without.empty()) {
    measurements.push_back(observed(equations, robot, arguments.without, arguments, progress));
  }
  return fitted_payload(model, robot, std::move(measurements));
}

FittedPayload from_wrist(const LoadedRobot& robot, const PayloadArguments& arguments, Progress& progress) {
  Measurement measurement = observed(WristEquations(robot), robot, arguments.logs, arguments, progress);
  return {estimate_payload_at_wrist(measurement.observations), {}, {}, {std::move(measurement)}};
}

// Gains that are not given count as 1 while they are looked for.
void give_gains(LoadedRobot& robot) {
  for (Body& body : robot.mechanism.bodies) {
    if (!body.current_to_torque) body.current_to_torque = 1;
  }
}

void check_logs_of_gains(const std::vector<Measurement>& measurements, const PayloadArguments& arguments) {
  bool are_currents = true, are_torques = true;
  for (const Measurement& each : measurements) {
    for (const MeasuredLog& log : each.logs) {
      are_currents = are_currents && log.has_currents;
      are_torques = are_torques && !log.has_currents && !log.has_mixed_currents;
      if (!log.has_tip_force) continue;
      throw Failure(FailureKind::unsupported, fmt::format("{}: --known-mass with forces at the tip", log.identity.name),
                    "leave the columns of the tip's force out, with the tip free");
    }
  }
  if (!are_currents && !are_torques) {
    throw Failure(FailureKind::usage, "--known-mass: some columns are currents, and others are torques",
                  "give all columns of all logs in A, or all in N m");
  }
  if (are_currents || arguments.output.empty()) return;
  throw Failure(FailureKind::usage, "-o with --known-mass writes gains of currents, but the logs have torques",
                "name their columns \"tau1 [A]\" and so on if they are currents, or leave -o out");
}

ExitCode estimate_gains(LoadedRobot robot, const PayloadArguments& arguments) {
  refuse_springs(robot, "payload --known-mass", "");
  if (robot.mechanism.has_spherical_joints()) {
    throw Failure(FailureKind::unsupported, "payload --known-mass is for robots without spherical joints");
  }
  give_gains(robot);
  Progress progress(arguments.quiet);
  const TorqueModel model(robot, parameter_set(arguments.parameters, robot.mechanism), progress);
  const TorqueEquations equations(model);
  std::vector<Measurement> measurements = {observed(equations, robot, arguments.logs, arguments, progress),
                                           observed(equations, robot, arguments.without, arguments, progress)};
  check_logs_of_gains(measurements, arguments);
  progress.step("estimating");
  const DriveGains found = drive_gains(model, std::move(measurements), *arguments.known_mass);
  if (!found.converged) {
    throw Failure(FailureKind::input, "the search for the gains of the drives does not come to rest",
                  "is it the same arm in both sets of logs, with the payload in --data and free in --without?");
  }
  std::vector<std::string> warning_texts = gain_warnings(robot, found);
  for (std::string& each : plausibility_warnings(robot, found.fit, "")) warning_texts.push_back(std::move(each));
  arguments.warn_of(warning_texts, arguments.logs.front());
  std::vector<TextFile> files;
  if (!arguments.output.empty()) files.push_back({arguments.output, gains_scene_text(robot, found, warning_texts)});
  write_and_print(files, {describe_drive_gains(robot, found), drive_gains_json(robot, found)}, arguments);
  return ExitCode::ok;
}

// A possible reason of a negative mass.
std::string hint_of(const LoadedRobot& robot, const PayloadArguments& arguments) {
  if (arguments.wrist) return "are the sensor's forces those that the link exerts, or those that it feels?";
  if (!arguments.without.empty()) return "are --data and --without exchanged?";
  return fmt::format("are the robot file's masses right? A log --without the payload takes their place{}",
                     robot.mechanism.floating_base
                         ? "; or are base_fx to base_nz what the base exerts, and not what is exerted on it?"
                         : "");
}

ExitCode payload(const PayloadArguments& arguments) {
  const LoadedRobot robot = load_robot(arguments.robot, arguments.options());
  refuse_loops(robot, "payload");
  check_payload_usage(arguments, robot);
  print_diagnostics(robot.diagnostics, arguments);
  arguments.note_function_keys(robot);
  if (arguments.known_mass) return estimate_gains(robot, arguments);
  const std::vector<std::string> settings =
      arguments.output.empty() ? std::vector<std::string>() : arguments.settings(robot);
  FittedPayload found;
  {
    Progress progress(arguments.quiet);
    found = arguments.wrist ? from_wrist(robot, arguments, progress) : from_torques(robot, arguments, progress);
  }
  require_told(robot, found);
  const std::vector<std::string> warning_texts = plausibility_warnings(robot, found, hint_of(robot, arguments));
  arguments.warn_of(warning_texts, arguments.logs.front());
  std::vector<TextFile> files;
  if (!arguments.output.empty()) {
    files.push_back(
        {arguments.output, payload_robot_text(robot, found.payload, arguments.output, settings, warning_texts)});
  }
  write_and_print(files, {describe_payload(robot, found), payload_json(robot, found)}, arguments);
  return ExitCode::ok;
}

}  // namespace

Run add_payload(CLI::App& app) {
  auto* command =
      app.add_subcommand("payload",
                         "Estimate what the tip carries, from motion with it.\n\n"
                         "  flatdyn payload robots/panda.urdf --data with.csv --without without.csv -o loaded.toml\n"
                         "  flatdyn payload robots/panda.urdf --tip panda_hand --data log.csv --wrist -o loaded.toml");
  const auto arguments = std::make_shared<PayloadArguments>();
  arguments->add_to(*command);
  command->add_option("--data", arguments->logs, "logs with the payload; columns as for identify")
      ->required()
      ->type_name("LOG.csv");
  command
      ->add_option("--without", arguments->without,
                   "logs without it, to compare with; default: the robot file's parameters")
      ->type_name("LOG.csv");
  command->add_flag("--wrist", arguments->wrist,
                    "from columns fx ... mz alone: what the tip's link exerts on the payload, along its axes");
  command
      ->add_option("--known-mass", arguments->known_mass,
                   "the payload has this mass: estimate the gains of the drives, by which currents (columns in A) or "
                   "torques are multiplied; needs --without")
      ->check(number_between(1e-6, 1e6))
      ->type_name("KG");
  command
      ->add_option("-o,--output", arguments->output,
                   "the robot file with the payload; with --known-mass a scene with the gains")
      ->check(kNotEmpty)
      ->type_name("FILE");
  add_identified_option(*command, arguments->parameters);
  add_stream_options(*command, arguments->stream);
  add_imu_option(*command, arguments->stream.imu);
  return [arguments] { return payload(*arguments); };
}

}  // namespace flatdyn
