// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <sstream>

#include "cli/commands.hpp"
#include "cli/output_file.hpp"
#include "diagnostics/version.hpp"
#include "identify/part_file.hpp"
#include "plot/time_table.hpp"
#include "report/identification_report.hpp"
#include "report/identified_robot.hpp"
#include "report/residual_plot.hpp"

namespace flatdyn {
namespace {

struct IdentifyArguments : RobotArguments {
  std::vector<std::string> logs, parts;
  std::string output, part;
  std::string parameters = "given";
  std::string frames = "file";
  StreamOptions stream;
  EstimateOptions estimate;
  bool sequential = false;
  std::string plot;

  // The file that is read first.
  const std::string& source() const { return logs.empty() ? parts.front() : logs.front(); }
};

// Parses "2/8", part 2 of 8.
void read_part(const std::string& text, StreamOptions& options) {
  int part = 0, parts = 0, length = 0;
  const bool read = std::sscanf(text.c_str(), "%d/%d%n", &part, &parts, &length) == 2;
  if (!read || static_cast<std::size_t>(length) != text.size() || part < 1 || part > parts) {
    throw Failure(ExitCode::usage, fmt::format("--part {}: write k/N with 1 <= k <= N, such as 2/8", text));
  }
  if (parts > kMostParts) {
    throw Failure(ExitCode::usage, fmt::format("--part {}: at most {} parts", text, kMostParts));
  }
  options.part = part;
  options.parts = parts;
}

void check_identify_usage(const IdentifyArguments& arguments) {
  if (arguments.logs.empty() == arguments.parts.empty()) {
    throw Failure(ExitCode::usage, "identify needs --data LOG.csv, or --merge PART..., and not both");
  }
  if (!arguments.part.empty() && (arguments.output.empty() || arguments.logs.empty())) {
    throw Failure(ExitCode::usage, "--part needs --data LOG.csv and -o FILE: the part is written to that file");
  }
  if (!arguments.parts.empty() && (arguments.stream.band || arguments.stream.decimate)) {
    throw Failure(ExitCode::usage, "--band and --decimate have no effect with --merge",
                  "give them with --part, where the logs are read");
  }
  if (!arguments.part.empty() && (!arguments.plot.empty() || arguments.sequential)) {
    throw Failure(ExitCode::usage, "--plot and --sequential have no effect with --part",
                  "give them with --merge, where the parameters are estimated");
  }
}

// Checks all files that are read or written.
void check_files(const IdentifyArguments& arguments, const Robot& robot) {
  std::vector<std::string> inputs = robot.files;
  inputs.insert(inputs.end(), arguments.logs.begin(), arguments.logs.end());
  inputs.insert(inputs.end(), arguments.parts.begin(), arguments.parts.end());
  check_outputs({arguments.output, arguments.plot}, inputs);
}

// Checks that some samples can be used, and that gaps in time, each of which costs a window of the filter, do not
// remove most of them.
void check_samples(const Measurement& measurement, const std::string& log, Diagnostics& found) {
  const StreamCount& count = measurement.count;
  int window = 0, decimate = 1;
  for (const SampleFilter& filter : measurement.filters()) {
    window = std::max(window, 2 * filter.half_window() + 1);
    decimate = std::max(decimate, filter.decimate);
  }
  if (count.used == 0) {
    throw Failure(
        ExitCode::input,
        fmt::format("none of {} samples can be used: the filter's window has {} of them{}", count.lines, window,
                    count.gaps > 0 ? fmt::format(", and there are {} gaps in time", count.gaps) : ""),
        count.gaps > 0 ? "log without gaps, or give a wider --band" : "log longer runs, or give a wider --band");
  }
  if (count.gaps == 0 || 2 * count.used * decimate > count.lines) return;
  found.warning({log, 0},
                fmt::format("{} gaps in time take most of {} samples: each costs the filter's window, {} samples",
                            count.gaps, count.lines, window),
                "log without gaps, or q, qd and qdd, so that there is no filter; a wider --band has a shorter window");
}

Measurement measured(const IdentifyArguments& arguments, const StreamOptions& options, const TorqueModel& model,
                     Progress& progress) {
  Diagnostics found;
  Measurement measurement;
  if (arguments.parts.empty()) {
    measurement = measure(model, {arguments.logs.begin(), arguments.logs.end()}, options, progress, found);
  } else {
    measurement = merge_parts({arguments.parts.begin(), arguments.parts.end()}, model, found);
  }
  // A single part may have no samples; all parts together must have some.
  const bool is_whole = arguments.part.empty() && !found.has_errors();
  if (is_whole) check_samples(measurement, arguments.source(), found);
  arguments.report(found);
  return measurement;
}

Eigen::VectorXd as_vector(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

// The lines of a report as comments, wide tables and all.
std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TextFile robot_file(const IdentifyArguments& arguments, const LoadedRobot& robot, const TorqueModel& model,
                    const Identification& found) {
  IdentifiedRobot about{arguments.output,
                        {fmt::format("Identified by flatdyn {} from measured motion.", kProgramVersion), ""},
                        arguments.settings(robot)};
  for (const std::string& line : lines_of(describe_identification(model, found))) about.comments.push_back(line);
  if (!found.warning_texts.empty()) about.comments.emplace_back();
  about.comments.insert(about.comments.end(), found.warning_texts.begin(), found.warning_texts.end());
  return {arguments.output, identified_robot_text(robot, parameter_set(arguments.parameters), found.physical, about)};
}

std::vector<TextFile> result_files(const IdentifyArguments& arguments, const LoadedRobot& robot,
                                   const TorqueModel& model, const Identification& found) {
  std::vector<TextFile> files;
  if (!arguments.output.empty()) files.push_back(robot_file(arguments, robot, model, found));
  if (!arguments.plot.empty())
    files.push_back({arguments.plot, residual_plot(model, found, picture_format(arguments.plot))});
  return files;
}

ExitCode identify(const IdentifyArguments& arguments) {
  check_identify_usage(arguments);
  StreamOptions stream = arguments.stream;
  if (!arguments.part.empty()) read_part(arguments.part, stream);
  const LoadedRobot robot = load_robot(arguments.robot, arguments.options());
  check_files(arguments, robot.robot);
  print_diagnostics(robot.diagnostics, arguments);
  arguments.note_function_keys(robot);
  // Settings that cannot be repeated are refused before logs are read.
  if (!arguments.output.empty()) arguments.settings(robot);
  Identification found;
  found.frames = parameter_frames(arguments.frames);
  {
    Progress progress(arguments.quiet);
    const TorqueModel model(robot, parameter_set(arguments.parameters), progress);
    found.measurement = measured(arguments, stream, model, progress);
    if (!arguments.part.empty()) {
      write_files({{arguments.output, part_text(found.measurement, model, stream)}});
      fmt::print("wrote {}: part {} of {}, {} samples\n", arguments.output, stream.part, stream.parts,
                 found.measurement.count.used);
      return ExitCode::ok;
    }
    progress.step("estimating");
    const Eigen::VectorXd file = as_vector(model.file_values());
    EstimateOptions options = arguments.estimate;
    options.acceleration_rows = [&](const EquationInstant& instant) {
      return model.acceleration_rows(instant.q.data());
    };
    found.estimate = estimate(found.measurement.observations, file, options);
    if (arguments.sequential) found.joint_by_joint = estimate_joint_by_joint(found.measurement.observations, file);
    progress.step("finding links that a body can have");
    // Friction and rotors that the estimate leaves out are left out of the robot that it is applied to, too.
    const bool inertial_only = parameter_set(arguments.parameters) == ParameterSet::inertial;
    found.physical =
        physical_parameters(inertial_only ? model.mechanism() : robot.mechanism, model.base(), found.estimate);
    found.warning_texts = plausibility_warnings(model, found);
    arguments.warn_of(found.warning_texts, arguments.source());
    write_and_print(result_files(arguments, robot, model, found),
                    {describe_identification(model, found), identification_json(model, found)}, arguments);
  }
  return ExitCode::ok;
}

}  // namespace

Run add_identify(CLI::App& app) {
  auto* command =
      app.add_subcommand("identify",
                         "Estimate the robot's dynamic parameters from measured motion.\n\n"
                         "  flatdyn identify robots/panda.urdf --data log.csv -o identified.toml\n"
                         "  flatdyn identify robots/panda.urdf --merge part1.json part2.json -o identified.toml");
  const auto arguments = std::make_shared<IdentifyArguments>();
  arguments->add_to(*command);
  command->add_option("--data", arguments->logs, "logs: t, q1..., tau1..., and qd, qdd, h_e where there are any")
      ->type_name("LOG.csv");
  command->add_option("--merge", arguments->parts, "instead of logs: all parts that --part has written")
      ->type_name("PART");
  command->add_option("-o,--output", arguments->output, "the robot file with the identified parameters; of a part")
      ->check(kNotEmpty)
      ->type_name("FILE");
  add_plot_option(*command, arguments->plot, "torques and residuals over time");
  command->add_option("--part", arguments->part, "read the k-th of N parts of the logs, and write what it says")
      ->type_name("k/N");
  add_parameters_option(*command, arguments->parameters, "what is identified: ");
  add_frames_option(*command, arguments->frames);
  add_stream_options(*command, arguments->stream);
  command
      ->add_option("--damping", arguments->estimate.damping,
                   "directions whose relative singular value is below this stay near the file's values")
      ->check(number_between(0, 1))
      ->capture_default_str();
  command->add_flag("--sequential", arguments->sequential, "also the textbook's joint-by-joint procedure");
  return [arguments] { return identify(*arguments); };
}

}  // namespace flatdyn
