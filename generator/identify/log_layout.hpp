// SPDX-License-Identifier: GPL-2.0-or-later
// The contents of a log and the places of its columns: the channels of one sample, in SI units.
#pragma once

#include <string>
#include <vector>

#include "diagnostics/diagnostics.hpp"
#include "input/csv/clock.hpp"
#include "model/mechanism.hpp"

namespace flatdyn {

// The channels of a sample: time, q, and, where the log has them, τ, q̇, q̈ and the tip force. With closed loops, q has
// more entries than the others: q̇_i is the rate of q[position_of[i]].
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

  // Whether times are read as text, with the first one subtracted from them.
  bool has_exact_time() const { return has_nanoseconds || clock.origin; }
  // The name of each channel's column as written, for messages.
  std::vector<std::string> channel_names() const;
};

// Reads a heading such as "t, q1 [deg], q_elbow, tau1, …" (docs/csv.md); `first_row` is the line below it. Errors (a
// column missing or twice, an unknown unit) go into `diagnostics`, and so do notes on columns that are not used. If
// `torques` is false, torques may be missing and are not read.
LogHeading read_heading(const std::string& line, const std::string& first_row, const Place& place,
                        const Mechanism& mechanism, bool torques, Diagnostics& diagnostics);

}  // namespace flatdyn
