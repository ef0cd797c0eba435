// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "base/diagnostics/version.hpp"
#include "cli/identify_options.hpp"
#include "cli/output_file.hpp"
#include "laboratory/identify/huber.hpp"
#include "laboratory/identify/instrumental_variables.hpp"
#include "laboratory/identify/part_file.hpp"
#include "laboratory/identify/rest_search.hpp"
#include "laboratory/identify/temperature_survey.hpp"
#include "laboratory/identify/usable_samples.hpp"
#include "report/identification_files.hpp"
#include "report/identification_report.hpp"
#include "report/identified_robot.hpp"
#include "report/plot/time_table.hpp"
#include "report/residual_plot.hpp"

namespace flatdyn {
namespace {

// Checks that a motion is there which is slower than the one that the filter leaves.
void require_filter(const Measurement& measurement) {
  const std::vector<SampleFilter> filters = measurement.filters();
  const bool is_filtered =
      std::all_of(filters.begin(), filters.end(), [](const SampleFilter& filter) { return filter.band > 0; });
  if (is_filtered) return;
  throw Failure(FailureKind::usage,
                "--estimator iv needs the filter: the log has all derivatives, and is used as it is", "give --band HZ");
}

// The logs of a run. What is found in them is reported when they are read for the first time.
class Logs {
 public:
  Logs(const IdentifyArguments& arguments, StreamOptions options, Progress& progress)
      : arguments_(arguments), options_(std::move(options)), progress_(progress) {}

  void set_delay(double delay) { options_.delay = delay; }
  void set_rest_speeds(std::vector<double> speeds) { options_.rest_speed = std::move(speeds); }
  bool has_rest_speeds() const { return !options_.rest_speed.empty(); }

  Measurement measured(const TorqueEquations& equations, const RowWeight& weight = nullptr,
                       const LogSink& also = nullptr) {
    Diagnostics found;
    Measurement measurement;
    if (arguments_.parts.empty()) {
      measurement = measure(equations, equations.model().mechanism(), {arguments_.logs.begin(), arguments_.logs.end()},
                            options_, progress_, found, weight, also);
    } else {
      measurement = merge_parts({arguments_.parts.begin(), arguments_.parts.end()}, equations, found);
    }
    // A single part may have no samples; all parts together must have some.
    const bool is_whole = arguments_.part.empty() && !found.has_errors();
    if (is_whole) check_samples(measurement, equations.model().mechanism(), arguments_.source(), found);
    if (!reported_) arguments_.report(found);
    reported_ = true;
    return measurement;
  }

  // Measures with Huber's weights, until these hardly change the parameters.
  Measurement with_robust_weights(const TorqueEquations& equations, Measurement measurement) {
    constexpr int kMostRounds = 6;
    constexpr double kSmall = 0.05;  // standard deviations
    Estimate before = estimate_of(equations, measurement, arguments_.identification.estimate);
    for (int round = 0; round < kMostRounds; ++round) {
      measurement = measured(equations, huber_weights(equations, measurement, before.values));
      Estimate next = estimate_of(equations, measurement, arguments_.identification.estimate);
      const Eigen::ArrayXd change = (next.values - before.values).array().abs() / next.standard_deviations.array();
      before = std::move(next);
      if (!(change.maxCoeff() > kSmall)) break;
    }
    return measurement;
  }

  // Estimates by instrumental variables.
  Estimate with_instruments(const TorqueEquations& equations) {
    TorqueEquations instrumented(equations.model(), equations.further());
    instrumented.set_instruments();
    InstrumentSums sums(instrumented);
    const Measurement again =
        measured(instrumented, nullptr, [&](const FilteredEquations& each, int) { sums.add(each); });
    require_filter(again);
    EstimateOptions options = arguments_.identification.estimate;
    options.acceleration_rows = instrumented.acceleration_rows();
    return sums.estimate(again.observations, instrumented.file_values(), options);
  }

  // Other logs, filtered as those that the parameters come from, so that residuals can be compared.
  Measurement validation(const TorqueEquations& equations, const Measurement& estimated) const {
    Diagnostics found;
    StreamOptions options = options_;
    const double band = estimated.logs.front().filter.band;
    if (band > 0) options.band = band;
    options.part = options.parts = 1;
    const std::vector<std::filesystem::path> logs(arguments_.validation.begin(), arguments_.validation.end());
    Measurement measurement = measure(equations, equations.model().mechanism(), logs, options, progress_, found);
    if (!found.has_errors())
      check_samples(measurement, equations.model().mechanism(), arguments_.validation.front(), found);
    arguments_.report(found);
    return measurement;
  }

 private:
  const IdentifyArguments& arguments_;
  StreamOptions options_;
  Progress& progress_;
  bool reported_ = false;
};

// By joint; empty if they were not estimated.
std::vector<IdentifiedSpring> springs_of(const TorqueEquations& equations, const Eigen::VectorXd& values) {
  std::vector<IdentifiedSpring> springs;
  Eigen::Index next = equations.parameters() - equations.corrections() - equations.static_parameters();
  for (int i = 0; i < equations.model().joints() && equations.further().springs; ++i, next += 2) {
    springs.push_back({values(next), values(next + 1)});
  }
  return springs;
}

// The lines of a report as comments, wide tables and all.
std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TextFile robot_file(const IdentifyArguments& arguments, const LoadedRobot& robot, const TorqueEquations& equations,
                    const Identification& found) {
  IdentifiedRobot about{arguments.output,
                        {fmt::format("Identified by flatdyn {} from measured motion.", kProgramVersion), ""},
                        arguments.settings(robot),
                        springs_of(equations, found.physical_values())};
  const std::string report = describe_identification(equations, found, parameter_frames(arguments.frames));
  for (const std::string& line : lines_of(report)) about.comments.push_back(line);
  if (!found.warning_texts.empty()) about.comments.emplace_back();
  about.comments.insert(about.comments.end(), found.warning_texts.begin(), found.warning_texts.end());
  return {arguments.output, identified_robot_text(robot, arguments.identification.set, found.physical, about)};
}

std::vector<TextFile> result_files(const IdentifyArguments& arguments, const LoadedRobot& robot,
                                   const TorqueEquations& equations, const Identification& found, Logs& logs) {
  std::vector<TextFile> files;
  const TorqueModel& model = equations.model();
  const Eigen::VectorXd& values = found.estimate.values;
  const auto plot_of = [&](const Measurement& measurement, const std::string& file) {
    files.push_back({file, residual_plot(model, measurement.observations, values, picture_format(file))});
  };
  if (!arguments.output.empty()) files.push_back(robot_file(arguments, robot, equations, found));
  if (!arguments.plot.empty()) plot_of(found.measurement, arguments.plot);
  if (!arguments.validation_plot.empty()) plot_of(*found.validation, arguments.validation_plot);
  if (!arguments.covariance.empty()) files.push_back({arguments.covariance, covariance_csv(equations, found.estimate)});
  if (!arguments.module.empty()) {
    files.push_back({arguments.module, results_module(equations, found, parameter_frames(arguments.frames))});
  }
  if (!arguments.signals.empty()) {
    SignalTable table(equations, values);
    logs.measured(equations, nullptr, [&](const FilteredEquations& each, int log) { table.add(each, log); });
    files.push_back({arguments.signals, table.csv()});
  }
  return files;
}

// Finds unknowns in which the torques are not linear, or loads the model if there are none.
NonlinearFit fit_of_unknowns(IdentifyArguments& arguments, LoadedRobot robot, Logs& logs, Progress& progress) {
  const NonlinearOptions options{
      arguments.gravity_direction,        arguments.delay,           arguments.further.law,
      arguments.further.offsets,          arguments.further.springs, arguments.further.temperature,
      arguments.further.even_temperatures};
  if (!options.any()) {
    auto model = std::make_unique<TorqueModel>(robot, arguments.identification.set, progress);
    return {std::move(robot), std::move(model), arguments.further};
  }
  const auto measured = [&](const TorqueEquations& equations, double delay) {
    logs.set_delay(delay);
    return logs.measured(equations);
  };
  const auto robot_with = [&](const Eigen::Vector3d& gravity) {
    arguments.gravity = fmt::format("{:.9g},{:.9g},{:.9g}", gravity.x(), gravity.y(), gravity.z());
    return load_robot(arguments.robot, arguments.options());
  };
  NonlinearFit fit =
      nonlinear_fit(std::move(robot), arguments.identification.set, options, {measured, robot_with}, progress);
  if (arguments.estimator == "iv") {
    // The instrument has no columns of corrections.
    fit.further.speed_factors.clear();
    fit.further.gravity = nullptr;
    fit.further.delay = false;
  }
  return fit;
}

void tell_of_creep(const TorqueModel& model, const std::vector<double>& before, const std::vector<double>& speeds,
                   const IdentifyArguments& arguments) {
  std::vector<std::string> names;
  for (int i = model.first_joint(); i < model.equations(); ++i) {
    const double speed = speeds[static_cast<std::size_t>(i - model.first_joint())];
    if (speed > before[static_cast<std::size_t>(i)]) names.push_back(fmt::format("{} {:.2g}", model.name_of(i), speed));
  }
  Diagnostics said;
  said.note({arguments.source()},
            fmt::format("rows of slow joints fit worse than others, as joints creep, stick and slip there: those below "
                        "these speeds are left out (rad/s, m/s): {}",
                        fmt::join(names, ", ")),
            "--rest-speed decides otherwise");
  arguments.report(said);
}

// Reads the logs again without rows in which joints creep, where these fit worse than others.
Measurement with_better_rest_speeds(const TorqueEquations& equations, Measurement measurement,
                                    const IdentifyArguments& arguments, Logs& logs) {
  if (has_speed(arguments.further.law)) return measurement;
  const Eigen::VectorXd values = estimate_of(equations, measurement, arguments.identification.estimate).values;
  std::vector<double> speeds = better_rest_speeds(equations, measurement, values);
  if (speeds.empty()) return measurement;
  tell_of_creep(equations.model(), measurement.rest_speeds(), speeds, arguments);
  logs.set_rest_speeds(std::move(speeds));
  return logs.measured(equations);
}

ExitCode identify(IdentifyArguments arguments) {
  settle(arguments);
  const StreamOptions& stream = arguments.stream;
  LoadedRobot robot = load_robot(arguments.robot, arguments.options());
  if (!arguments.further.springs) {
    refuse_springs(robot, "identify", robot.mechanism.is_coupled() ? "" : "--springs estimates them; ");
  }
  check_files(arguments, robot.robot);
  print_diagnostics(robot.diagnostics, arguments);
  arguments.note_function_keys(robot);
  check_options_for(robot.mechanism, arguments);
  arguments.identification.set = parameter_set(arguments.parameters, robot.mechanism);
  require_friction(robot.mechanism, arguments);
  // Settings that cannot be repeated are refused before logs are read.
  if (!arguments.output.empty()) arguments.settings(robot);
  if (arguments.further.temperature && arguments.part.empty() && arguments.parts.empty()) {
    arguments.further.even_temperatures = even_temperatures({arguments.logs.begin(), arguments.logs.end()},
                                                            robot.mechanism, stream, *arguments.further.temperature);
  }
  Progress progress(arguments.quiet);
  Logs logs(arguments, stream, progress);
  const NonlinearFit fit = fit_of_unknowns(arguments, std::move(robot), logs, progress);
  const TorqueModel& model = *fit.model;
  const TorqueEquations equations(model, fit.further);
  Measurement measurement = logs.measured(equations);
  if (!arguments.part.empty()) {
    write_files({{arguments.output, part_text(measurement, equations, stream)}});
    erase_progress();
    fmt::print("wrote {}: part {} of {}, {} samples\n", arguments.output, stream.part, stream.parts,
               measurement.count.used);
    return ExitCode::ok;
  }
  if (!logs.has_rest_speeds() && arguments.parts.empty()) {
    measurement = with_better_rest_speeds(equations, std::move(measurement), arguments, logs);
  }
  if (arguments.robust) measurement = logs.with_robust_weights(equations, std::move(measurement));
  if (arguments.estimator == "iv") {
    arguments.identification.other_estimate = logs.with_instruments(equations);
  }
  Identification found =
      identification(fit.robot, equations, std::move(measurement), arguments.identification, progress);
  found.unknowns = fit.unknowns;
  set_deviations(found.unknowns, equations, found.estimate, found.measurement);
  leave_friction_open(found.estimate, found.unknowns, equations);
  if (!arguments.validation.empty()) validate(found, equations, logs.validation(equations, found.measurement));
  found.warning_texts = plausibility_warnings(model, found);
  for (std::string& each : search_warnings(found.unknowns, model)) found.warning_texts.push_back(std::move(each));
  for (std::string& each : temperature_warnings(equations, found.estimate)) {
    found.warning_texts.push_back(std::move(each));
  }
  arguments.warn_of(found.warning_texts, arguments.source());
  const ParameterFrames frames = parameter_frames(arguments.frames);
  write_and_print(result_files(arguments, fit.robot, equations, found, logs),
                  {describe_identification(equations, found, frames), identification_json(equations, found, frames)},
                  arguments);
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
  add_identify_options(*command, *arguments);
  return [arguments] { return identify(*arguments); };
}

}  // namespace flatdyn
