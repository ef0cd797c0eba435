// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/base_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "laboratory/identify/base_motion.hpp"

namespace flatdyn {
namespace {

// Whether the log has the force on the base, and it is always zero.
bool nothing_touches(const Mechanism& mechanism, const Observations& observations) {
  const auto first = observations.joints.begin();
  return std::all_of(first, first + mechanism.base_bodies(),
                     [](const JointObservations& each) { return each.rows > 0 && each.rms_torque() == 0; });
}

}  // namespace

std::vector<std::string> base_warnings(const Mechanism& mechanism, const Observations& observations,
                                       bool are_of_torques) {
  constexpr double kLittle = 0.3, kMuch = 3, kCarried = 0.5;  // shares of gravity, of a mean
  const std::vector<EquationInstant>& instants = observations.instants;
  const double gravity = base_sensors(mechanism, "").gravity.norm();
  if (!mechanism.floating_base || gravity == 0 || instants.empty()) return {};
  double sum = 0;
  for (const EquationInstant& each : instants) sum += Eigen::Map<const Eigen::Vector3d>(each.qdd.data()).norm();
  const double mean = sum / static_cast<double>(instants.size());
  const bool is_free = are_of_torques && nothing_touches(mechanism, observations);
  std::vector<std::string> warning_texts;
  if (is_free && mean > kCarried * gravity) {
    warning_texts.push_back(fmt::format(
        "the force on the base is zero in all of the log, and its specific force is {:.3g} m/s^2 on average: something "
        "carries the robot; leave base_fx to base_nz out, or log that force",
        mean));
  }
  if (is_free || (mean > kLittle * gravity && mean < kMuch * gravity)) return warning_texts;
  warning_texts.push_back(
      fmt::format("the base's specific force is {:.3g} m/s^2 on average, and that of a robot at rest is {:.3g}: is a "
                  "unit another one "
                  "(imu_ax [g], base_x [mm]), was gravity taken off an accelerometer, or does the robot fall?",
                  mean, gravity));
  return warning_texts;
}

// A log of a measurement unit has accelerations, which are read, and turns, which are differentiated.
std::string imu_question(const std::vector<MeasuredLog>& logs) {
  const bool is_of_unit = std::any_of(logs.begin(), logs.end(), [](const MeasuredLog& log) {
    const std::vector<int>& orders = log.differentiations;
    return orders.size() >= LogLayout::kTwist && orders[0] == 0 && orders[3] == 1;
  });
  return is_of_unit ? "; is the measurement unit in the base link's frame (--imu LINK says which)?" : "";
}

}  // namespace flatdyn
