// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/usable_samples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "robot/input/csv/clock.hpp"

namespace flatdyn {
namespace {

// Why no sample can be used.
Failure no_samples(const Measurement& measurement, int window, int decimate) {
  const StreamCount& count = measurement.count;
  const std::string none = fmt::format("none of {} samples can be used: ", count.lines),
                    of_filter = fmt::format("the filter's window has {} of them", window);
  const bool are_far_apart = std::any_of(measurement.logs.begin(), measurement.logs.end(),
                                         [](const MeasuredLog& log) { return log.filter.dt >= kFarApart; });
  if (are_far_apart) {
    return Failure(FailureKind::input, none + of_filter,
                   "poses that are held need columns qd1, ... and qdd1, ... of zeros: then each line counts as it is");
  }
  if (count.gaps > 0) {
    return Failure(FailureKind::input, fmt::format("{}{}, and there are {} gaps in time", none, of_filter, count.gaps),
                   "log without gaps, or give a wider --band");
  }
  if (count.lines > window && decimate > 1) {
    return Failure(FailureKind::input, fmt::format("{}--decimate {} leaves none of them", none, decimate),
                   fmt::format("give --decimate a number far below {}", count.lines - window));
  }
  return Failure(FailureKind::input, none + of_filter, "log longer runs, or give a wider --band");
}

// Why no joint counts as moving. `base`: the entries of q̇ of a floating base.
Failure no_motion(const Measurement& measurement, int base) {
  const std::vector<JointObservations>& joints = measurement.observations.joints;
  const std::vector<double> rest = measurement.rest_speeds();
  const double fastest = *std::max_element(rest.begin(), rest.end());
  const auto most =
      std::max_element(joints.begin(), joints.end(), [](const JointObservations& a, const JointObservations& b) {
        return a.left_out < b.left_out;
      })->left_out;
  const std::vector<EquationInstant>& instants = measurement.observations.instants;
  const bool moves = std::any_of(instants.begin(), instants.end(), [&](const EquationInstant& instant) {
    return !std::equal(rest.begin() + base, rest.end(), instant.qd.begin() + base,
                       [](double slowest, double qd) { return std::abs(qd) <= slowest; });
  });
  if (most > 0 || moves) {
    return Failure(FailureKind::input,
                   fmt::format("every joint moves clearly faster than the noise of its position at few instants only, "
                               "at {} of {} at most, too few to tell their noise by; a joint counts as resting below "
                               "{:.2g} rad/s or m/s",
                               most, measurement.count.used, fastest),
                   "log a longer or faster motion (flatdyn excite finds one); or give a wider --band, which has more "
                   "instants, a lower one, which has less noise, or --rest-speed");
  }
  return Failure(FailureKind::input,
                 fmt::format("no joint moves faster than the speed below which it counts as resting, {:.2g} rad/s or "
                             "m/s at most: at rest a joint's friction may be anything up to F_s, so that its torques "
                             "tell nothing",
                             fastest),
                 "log a motion (flatdyn excite finds one); or log many poses, one line for each, with columns qd1, ... "
                 "and qdd1, ... of zeros, which tell the parameters of gravity");
}

// Whether a floating base turns, or what an accelerometer on it shows changes, by more than noise does.
bool base_moves(const Measurement& measurement) {
  constexpr double kTurns = 0.02, kForce = 0.1;  // rad/s; m/s²
  const std::vector<EquationInstant>& instants = measurement.observations.instants;
  return std::any_of(instants.begin(), instants.end(), [&](const EquationInstant& each) {
    const EquationInstant& first = instants.front();
    double force = 0, turns = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      force = std::max(force, std::abs(each.qdd[k] - first.qdd[k]));
      turns = std::max(turns, std::abs(each.qd[3 + k]));
    }
    return force > kForce || turns > kTurns;
  });
}

Failure no_equations() {
  return Failure(FailureKind::input, "the robot has no joints, and the log no force on its base: there is no equation",
                 "log the force on the base, base_fx to base_nz");
}

}  // namespace

void check_used_samples(const Measurement& measurement, const std::string& log, Diagnostics& found) {
  const StreamCount& count = measurement.count;
  int window = 0, decimate = 1;
  for (const SampleFilter& filter : measurement.filters()) {
    window = std::max(window, 2 * filter.half_window() + 1);
    decimate = std::max(decimate, filter.decimate);
  }
  if (count.used == 0) throw no_samples(measurement, window, decimate);
  if (count.gaps == 0 || 2 * count.used * decimate > count.lines - count.repeated) return;
  found.warning({log, 0},
                fmt::format("{} gaps in time take most of {} samples: each costs the filter's window, {} samples",
                            count.gaps, count.lines, window),
                "log without gaps, or q, qd and qdd, so that there is no filter; a wider --band has a shorter window");
}

void check_samples(const Measurement& measurement, const Mechanism& mechanism, const std::string& log,
                   Diagnostics& found) {
  check_used_samples(measurement, log, found);
  const std::vector<JointObservations>& joints = measurement.observations.joints;
  const auto has_no_rows = [](const JointObservations& joint) { return joint.rows == 0; };
  const auto first_joint = joints.begin() + mechanism.base_bodies();
  if (mechanism.joints().size() == 0 && std::all_of(joints.begin(), joints.end(), has_no_rows)) throw no_equations();
  const bool joints_rest = std::all_of(first_joint, joints.end(), has_no_rows);
  const bool base_rests =
      !mechanism.floating_base || !base_moves(measurement) || std::all_of(joints.begin(), first_joint, has_no_rows);
  if (joints_rest && base_rests) throw no_motion(measurement, mechanism.base_bodies());
}

}  // namespace flatdyn
