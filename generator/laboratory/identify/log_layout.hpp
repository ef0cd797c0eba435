// SPDX-License-Identifier: GPL-2.0-or-later
// The contents of a log and the places of its columns: the channels of one sample, in SI units.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics/diagnostics.hpp"
#include "robot/input/csv/clock.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

// How a log gives the motion of a floating base.
enum class BaseMotion : std::uint8_t {
  none,     // the base is fixed
  imu,      // specific force and angular velocity, by an inertial measurement unit that is fixed to the base link
  pose,     // position and unit quaternion, by motion capture; twists as well, where the log has them
  gravity,  // twist, and gravity in base axes
};

// The channels of a sample: time, q, and, where the log has them, τ, q̇, q̈, the tip force, the motion of the base and
// temperatures of the joints.
// With closed loops, q has more entries than the others: q̇_i is the rate of q[position_of[i]]. A spherical joint has
// four entries in q, a unit quaternion w, x, y, z, and three in the others. q̇ and q̈ have no channels of a floating
// base, whose first six entries of τ are zeros where the log lacks them.
struct LogLayout {
  int joints = 0, positions = 0;  // entries of q̇ without those of a floating base; entries of q
  int base = 0;                   // entries of q̇ that are the motion of a floating base: 0 or 6
  // By entry of q̇: its entry of q; x, y and z of a spherical joint's quaternion for its three; -1 for a floating base,
  // which has no position in q.
  std::vector<int> position_of{};
  // The entries of q̇ with which those of spherical joints begin, and the entries of q with which their quaternions do.
  std::vector<int> spherical{}, spherical_positions{};
  bool has_torques = true;
  // Whether all torques of joints come from currents, by the gains of the drives; whether some do and some do not.
  bool has_currents = false, has_mixed_currents = false;
  bool has_rates = false, has_accelerations = false, has_tip_force = false;
  BaseMotion base_motion = BaseMotion::none;
  bool has_base_force = false, has_twist = false, has_twist_rates = false;
  bool has_temperatures = false;
  bool has_place = false;  // whether the log has the position of a pose; zeros stand for it where it has a twist

  static constexpr int kWrench = 6, kTwist = 6, kPose = 7, kQuaternionInPose = 3, kGravity = 3;
  static constexpr int kTurns = 3, kQuaternion = 4;
  // Entries of q̇, q̈ and τ.
  int rates() const { return base + joints; }
  // Whether nothing has to be differentiated.
  bool has_all_derivatives() const {
    return has_rates && has_accelerations && (base_motion == BaseMotion::none || has_twist_rates);
  }
  static constexpr int time() { return 0; }
  static constexpr int q() { return 1; }
  int tau() const { return 1 + positions; }
  int qd() const { return tau() + (has_torques ? rates() : 0); }
  int qdd() const { return qd() + (has_rates ? joints : 0); }
  int h_e() const { return qdd() + (has_accelerations ? joints : 0); }
  // The pose, the inertial measurement unit's readings or gravity: what determines the base's motion.
  int base_reading() const { return h_e() + (has_tip_force ? kWrench : 0); }
  int base_readings() const {
    switch (base_motion) {
      case BaseMotion::imu:
        return kTwist;
      case BaseMotion::pose:
        return kPose;
      case BaseMotion::gravity:
        return kGravity;
      case BaseMotion::none:
        break;
    }
    return 0;
  }
  int twist() const { return base_reading() + base_readings(); }
  int twist_rates() const { return twist() + (has_twist ? kTwist : 0); }
  // One of each joint, °C.
  int temperatures() const { return twist_rates() + (has_twist_rates ? kTwist : 0); }
  int channels() const { return temperatures() + (has_temperatures ? joints : 0); }
  // The spherical joint that an entry of q̇ is of, by its place in `spherical`; none of other joints.
  std::optional<std::size_t> spherical_of(int rate) const {
    for (std::size_t k = 0; k < spherical.size(); ++k) {
      if (rate >= spherical[k] && rate < spherical[k] + kTurns) return k;
    }
    return std::nullopt;
  }
  // The channels with which quaternions begin: those of spherical joints, then that of a floating base's pose.
  std::vector<int> quaternions() const {
    std::vector<int> result;
    for (const int position : spherical_positions) result.push_back(q() + position);
    if (base_motion == BaseMotion::pose) result.push_back(base_reading() + kQuaternionInPose);
    return result;
  }
  // The channels that are differentiated twice where the log lacks rates: q, and the pose of a floating base.
  std::vector<int> positions_of_all() const {
    std::vector<int> result;
    for (int i = 0; i < positions; ++i) result.push_back(q() + i);
    for (int i = 0; base_motion == BaseMotion::pose && i < kPose; ++i) result.push_back(base_reading() + i);
    return result;
  }

  bool operator==(const LogLayout&) const = default;
};

// One column of the file.
struct LogColumn {
  enum class Role {
    unused,
    number,       // the entry times its factor goes into its channel, in SI units
    time,         // the clock's text, with more digits than a double has
    nanoseconds,  // the nanoseconds of the clock, as text
    fixed_text    // the name of a joint, the same in all rows
  };

  std::string name;  // as written
  Role role = Role::unused;
  int channel = -1;
  double factor = 1;
  std::string text{};  // the fixed text
};

struct LogHeading {
  LogLayout layout;
  std::vector<LogColumn> columns;
  char separator = ',';
  CsvClock clock{};
  bool has_nanoseconds = false;  // nanoseconds have a column of their own
  double rate = 0;               // samples a second, where it is given: no column has times then; else 0

  // Whether times are read as text, with the first one subtracted from them.
  bool has_exact_time() const { return has_nanoseconds || clock.origin; }
  // The name of each channel's column as written, for messages.
  std::vector<std::string> channel_names() const;
};

// A log must have these besides positions, and others are not read.
struct LogNeeds {
  bool torques = true, temperatures = false;
};

// Reads a heading such as "t, q1 [deg], q_elbow, tau1, …" (docs/csv.md); `first_row` is the line below it. Errors (a
// column missing or twice, an unknown unit) go into `diagnostics`, and so do notes on columns that are not used.
// `rate`: LogHeading::rate.
LogHeading read_heading(const std::string& line, const std::string& first_row, const Place& place,
                        const Mechanism& mechanism, const LogNeeds& needs, double rate, Diagnostics& diagnostics);

}  // namespace flatdyn
