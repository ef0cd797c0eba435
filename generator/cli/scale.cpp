// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <sstream>

#include "cli/commands.hpp"
#include "cli/output_file.hpp"
#include "laboratory/trajectory/closed_positions.hpp"
#include "laboratory/trajectory/read_trajectory.hpp"
#include "laboratory/trajectory/resampling.hpp"
#include "report/scaling_report.hpp"
#include "report/torque_report.hpp"

namespace flatdyn {
namespace {

constexpr double kLeastScaling = 1e-6;    // least value of --faster
constexpr double kLimitTolerance = 1e-9;  // relative tolerance of the second pass
constexpr int kDefaultGrid = 1000;
constexpr int kMostSamples = 1'000'000;  // of --rate; each takes some hundred bytes for an arm
constexpr double kWholeNumber = 1e-9;    // relative tolerance of a number of intervals that is whole already

struct ScaleArguments : RobotArguments {
  std::string trajectory, output, plot, torque_limits;
  bool faster = false, time_optimal = false;
  std::optional<int> grid;
  std::optional<double> rate;
};

void check_scale_usage(const ScaleArguments& arguments) {
  if (arguments.grid && !arguments.time_optimal) {
    throw Failure(FailureKind::usage, "--grid has no effect without --time-optimal");
  }
  if (arguments.grid && !is_plan(arguments.trajectory)) {
    throw Failure(FailureKind::usage, "--grid has no effect on samples: they are the grid", "leave it out");
  }
  if (arguments.faster && arguments.time_optimal) {
    throw Failure(FailureKind::usage, "--faster is for the linear law; --time-optimal is as fast as it can be anyway");
  }
}

// Parses "3000" for all joints, or "3000,1500".
std::vector<double> torque_limits_option(const std::string& text, std::size_t joints) {
  std::vector<double> limits;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    double value = 0;
    const bool read = CLI::detail::lexical_cast(part, value) && value > 0;
    if (!read)
      throw Failure(FailureKind::usage, fmt::format("--torque-limits: \"{}\" is no number greater than 0", part));
    limits.push_back(value);
  }
  if (limits.size() == 1) limits.resize(joints, limits[0]);
  if (limits.size() == joints) return limits;
  throw Failure(FailureKind::usage,
                fmt::format("--torque-limits: {} numbers, but the robot has {} joints", limits.size(), joints),
                "one for all joints, or one for each in the order of flatdyn inspect, inf for none");
}

PaceLimits limits_of(const ScaleArguments& arguments, const LoadedRobot& model) {
  PaceLimits limits = given_limits(model.mechanism);
  if (!arguments.torque_limits.empty()) {
    limits.torque = torque_limits_option(arguments.torque_limits, model.mechanism.joints().size());
  }
  if (limits.are_infinite()) {
    throw Failure(FailureKind::unsupported, fmt::format("{}: no joint has a limit", model.robot.file),
                  "give --torque-limits, or limits in the robot file or a scene");
  }
  return limits;
}

[[noreturn]] void refuse_static_load(const ScaleArguments& arguments, const LoadedRobot& model,
                                     const Trajectory& trajectory, const PathCoefficients& path,
                                     const PaceLimits& limits) {
  const LargestLimitUse load = largest_static_load(path, limits);
  Diagnostics found;
  found.error(
      {arguments.trajectory, 0},
      fmt::format("no {}pace keeps the limits: at {:.6g} s joint \"{}\" needs {:.6g} {} at rest already, against "
                  "gravity{}, beyond the {}",
                  arguments.faster || arguments.time_optimal ? "" : "slower ", trajectory.points[load.point].time,
                  model.mechanism.joints()[load.joint].joint, path.d[load.point * path.joints + load.joint],
                  torque_unit(model.mechanism.joints()[load.joint]), ", dry friction and the tip's force",
                  limit_text(model.mechanism, limits, load.kind, load.joint)),
      arguments.faster || arguments.time_optimal
          ? "choose a path through other postures, or stronger motors"
          : "a faster one may (--faster), or choose a path through other postures");
  throw BadInput(FailureKind::input, found);
}

// The fewest intervals of 1 / rate that take the duration, or longer. A rate at which the motion is over before the
// second sample is refused.
int intervals_of(double duration, double rate) {
  constexpr double kFewest = 10;  // intervals that suffice to recognise a motion
  const double wanted = duration * rate, nearest = std::round(wanted);
  const bool is_whole = std::abs(wanted - nearest) <= kWholeNumber * wanted;
  if (wanted < 1 && !is_whole) {
    throw Failure(FailureKind::usage,
                  fmt::format("--rate {} has no sample within the motion, which takes {:.6g} s", rate, duration),
                  fmt::format("give --rate {:.3g} or more", std::ceil(kFewest / duration)));
  }
  const double intervals = is_whole ? nearest : std::ceil(wanted);
  if (intervals < kMostSamples) return static_cast<int>(intervals);
  throw Failure(FailureKind::usage, fmt::format("--rate {} makes {:.0f} samples of {:.6g} s; at most {} are written",
                                                rate, intervals + 1, duration, kMostSamples));
}

double milliseconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

class Scaling {
 public:
  Scaling(const ScaleArguments& arguments, const LoadedRobot& model) : arguments_(arguments), model_(model) {
    motion_.limits = limits_of(arguments, model);
  }

  ScaledMotion run() {
    read();
    Progress progress(arguments_.quiet);
    PathTorques torques(model_, motion_.before.has_tip_force(), progress);
    find_linear(torques);
    if (arguments_.time_optimal) {
      find_optimal(torques);
    } else {
      motion_.after = slowed(motion_.before, motion_.linear.c);
    }
    check(with_both_sides(motion_.after), torques);
    if (arguments_.rate) sample_evenly(torques);
    motion_.tau_after = torques.torques(motion_.after);
    if (motion_.used.part > 1 + kLimitTolerance) {
      throw Failure(FailureKind::bug, fmt::format("the scaled motion uses {:.12g} of a limit", motion_.used.part),
                    "please report it with the robot file and the trajectory");
    }
    return std::move(motion_);
  }

 private:
  // Reads the trajectory. A plan is sampled at twice as many points as the grid has, so that limits can be checked
  // between them.
  void read() {
    Diagnostics found;
    const bool doubled = arguments_.time_optimal && is_plan(arguments_.trajectory);
    const std::optional<int> intervals =
        doubled ? std::optional(2 * arguments_.grid.value_or(kDefaultGrid)) : std::nullopt;
    motion_.before = read_trajectory(arguments_.trajectory, model_.robot, model_.mechanism, found, intervals);
    arguments_.report(found);
    if (!doubled) return;
    finer_ = std::move(motion_.before);
    motion_.before = every_second(finer_);
  }

  void find_linear(PathTorques& torques) {
    motion_.sides_before = with_both_sides(motion_.before);
    motion_.tau_sides_before = torques.torques(motion_.sides_before);
    const PathCoefficients path = torques.coefficients(motion_.sides_before);
    const double least = arguments_.faster || arguments_.time_optimal ? kLeastScaling : 1;
    const std::optional<LinearScaling> linear = linear_scaling(motion_.sides_before, path, motion_.limits, least);
    if (!linear) refuse_static_load(arguments_, model_, motion_.sides_before, path, motion_.limits);
    motion_.linear = *linear;
  }

  void find_optimal(PathTorques& torques) {
    OptimalPace pace;
    auto start = std::chrono::steady_clock::now();
    const PathCoefficients path = torques.coefficients(motion_.before);
    pace.coefficients_ms = milliseconds_since(start);
    start = std::chrono::steady_clock::now();
    pace.law = time_optimal_law(motion_.before, path, motion_.limits, motion_.linear.c);
    pace.solve_ms = milliseconds_since(start);
    motion_.after = paced(motion_.before, pace.law);
    pace.slowed_by = slow_down_to_limits(torques);
    if (!finer_.points.empty()) {
      const Trajectory between = slowed(paced_between(finer_, pace.law), pace.slowed_by);
      pace.between = largest_limit_use(between, torques.torques(between), motion_.limits);
    }
    motion_.optimal = std::move(pace);
  }

  // Slows the whole motion down where the law exceeds a limit a little, between the grid's points or because friction
  // is linearised, but at most to the pace of the linear law. Returns the factor.
  double slow_down_to_limits(PathTorques& torques) {
    const Trajectory sides = with_both_sides(motion_.after);
    if (largest_limit_use(sides, torques.torques(sides), motion_.limits).part <= 1 + kLimitTolerance) return 1;
    const auto again = linear_scaling(sides, torques.coefficients(sides), motion_.limits, 1);
    const double linear = motion_.linear.c * motion_.before.duration();
    const bool is_faster = again && again->c * motion_.after.duration() < linear;
    const double factor = is_faster ? again->c : linear / motion_.after.duration();
    motion_.after = is_faster ? slowed(motion_.after, factor) : slowed(motion_.before, motion_.linear.c);
    return factor;
  }

  // Evaluates the use of limits by the scaled motion, at these points.
  void check(Trajectory points, PathTorques& torques) {
    motion_.sides_after = std::move(points);
    motion_.tau_sides_after = torques.torques(motion_.sides_after);
    motion_.used = largest_limit_use(motion_.sides_after, motion_.tau_sides_after, motion_.limits);
  }

  // Replaces the scaled motion by even samples. The whole motion is slowed down until it ends on one, and until all
  // limits hold at the new samples as well as at the old ones.
  void sample_evenly(PathTorques& torques) {
    const Trajectory found = motion_.after;
    const double duration = found.duration(), rate = *arguments_.rate;
    int intervals = intervals_of(duration, rate);
    while (true) {
      const double slowed_by = intervals / rate / duration;
      const Trajectory slow = slowed(found, slowed_by);
      motion_.after = resampled(slow, intervals);
      motion_.even = EvenSamples{rate, slowed_by};
      Trajectory all = with_both_sides(slow);
      all.points.insert(all.points.end(), motion_.after.points.begin(), motion_.after.points.end());
      check(std::move(all), torques);
      if (motion_.used.part <= 1 + kLimitTolerance) return;
      const PathCoefficients path = torques.coefficients(motion_.sides_after);
      const auto needed = linear_scaling(motion_.sides_after, path, motion_.limits, 1);
      if (!needed) refuse_static_load(arguments_, model_, motion_.sides_after, path, motion_.limits);
      intervals = std::max(intervals + 1, intervals_of(needed->c * slowed_by * duration, rate));
    }
  }

  const ScaleArguments& arguments_;
  const LoadedRobot& model_;
  ScaledMotion motion_;
  Trajectory finer_;
};

ExitCode scale(const ScaleArguments& arguments) {
  check_scale_usage(arguments);
  const LoadedRobot model = load_robot(arguments.robot, arguments.options_without_error_budget());
  refuse_floating_base(model, "scale");
  refuse_spherical_joints(model, "scale");
  print_diagnostics(model.diagnostics, arguments);
  arguments.note_function_keys(model);
  std::vector<std::string> inputs = model.robot.files;
  inputs.push_back(arguments.trajectory);
  check_outputs({arguments.output, arguments.plot}, inputs);
  const ScaledMotion motion = Scaling(arguments, model).run();
  const TimeTable table = trajectory_table(motion.after, positions_along(model, motion.after), motion.tau_after);
  std::vector<TextFile> files = {{arguments.output, csv_text(table)}};
  if (!arguments.plot.empty()) {
    files.push_back({arguments.plot, time_plot(model.mechanism.name + ": the scaled motion", table,
                                               motion_panels(model.mechanism, motion.after.has_tip_force()),
                                               picture_format(arguments.plot))});
  }
  write_and_print(files, {describe_scaling(model.mechanism, motion) + "\n", scaling_json(model.mechanism, motion)},
                  arguments);
  return ExitCode::ok;
}

}  // namespace

Run add_scale(CLI::App& app) {
  auto* command = app.add_subcommand(
      "scale",
      "Change the pace of a motion so that it keeps the limits of its joints.\n\n"
      "  flatdyn scale robots/planar_2r_example_7_2.toml --trajectory docs/examples/planar_2r_triangular.toml \\\n"
      "      --torque-limits 3000 -o out.csv\n"
      "  flatdyn scale robots/panda.urdf --trajectory motion.csv --time-optimal -o out.csv");
  const auto arguments = std::make_shared<ScaleArguments>();
  arguments->add_to(*command);
  add_trajectory_option(*command, arguments->trajectory);
  command->add_option("-o,--output", arguments->output, "CSV: the motion at its new pace, and its torques")
      ->required()
      ->check(kNotEmpty)
      ->type_name("FILE.csv");
  command
      ->add_option("--torque-limits", arguments->torque_limits,
                   "N m or N, one for all joints or one for each, separated by commas; default: the robot's")
      ->check(kNotEmpty)
      ->type_name("L,L,...");
  command->add_flag("--faster", arguments->faster, "also make a motion faster that is slower than the limits allow");
  command->add_flag("--time-optimal", arguments->time_optimal,
                    "instead of one factor for the whole motion, the fastest pace at every point of the path");
  command
      ->add_option("--grid", arguments->grid, "for --time-optimal of a plan, at least so many intervals; default: 1000")
      ->check(CLI::Range(2, 1000000))
      ->type_name("N");
  command
      ->add_option(
          "--rate", arguments->rate,
          "samples per second, evenly spaced, made by polynomials of degree five through q, qd and qdd of the "
          "scaled samples; the motion takes a little longer, so that it ends on one and keeps all limits there")
      ->check(positive_number())
      ->type_name("HZ");
  add_plot_option(*command, arguments->plot, "positions, rates, accelerations and torques at the new pace");
  return [arguments] { return scale(*arguments); };
}

}  // namespace flatdyn
