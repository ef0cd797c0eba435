// SPDX-License-Identifier: GPL-2.0-or-later
// What a log holds, and where its columns go: the channels of one sample, in SI units.
#pragma once

#include <string>
#include <vector>

#include "diagnostics/diagnostics.hpp"
#include "model/mechanism.hpp"

namespace flatdyn {

// Channels of a sample: time, q, and, where the log has them, τ, q̇, q̈ and the tip force. Where loops are closed, q has
// more entries than the others: position_of[i] is the one that q̇_i is the rate of.
struct LogLayout {
  int joints = 0, positions = 0;
  std::vector<int> position_of{};
  bool has_torques = true;
  bool has_rates = false, has_accelerations = false, has_tip_force = false;

  static constexpr int kWrench = 6;
  static constexpr int time() { return 0; }
  static constexpr int q() { return 1; }
  int tau() const { return 1 + positions; }
  int qd() const { return tau() + (has_torques ? joints : 0); }
  int qdd() const { return qd() + (has_rates ? joints : 0); }
  int h_e() const { return qdd() + (has_accelerations ? joints : 0); }
  int channels() const { return h_e() + (has_tip_force ? kWrench : 0); }

  bool operator==(const LogLayout&) const = default;
};

// One column of the file: its channel (-1: not used) and the factor that makes its unit SI.
struct LogColumn {
  std::string name;  // as written
  int channel = -1;
  double factor = 1;
};

struct LogHeading {
  LogLayout layout;
  std::vector<LogColumn> columns;
};

// Reads "t, q1 [deg], q_elbow, tau1, …": joints by number or by name, units in brackets, SI where there are none:
// s, rad or m, N m or N. What is wrong (missing, twice, unknown unit) goes into `diagnostics`; columns with other names
// are left out with a note, or a warning if they are of joints that the robot does not have. Torques may be missing,
// and are not read, if `torques` is false.
LogHeading read_heading(const std::string& line, const Place& place, const Mechanism& mechanism, bool torques,
                        Diagnostics& diagnostics);

}  // namespace flatdyn
