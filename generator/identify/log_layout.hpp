// SPDX-License-Identifier: GPL-2.0-or-later
// What a log holds, and where its columns go: the channels of one sample, in SI units.
#pragma once

#include <string>
#include <vector>

#include "diagnostics/diagnostics.hpp"
#include "input/csv/clock.hpp"
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

// One column of the file.
struct LogColumn {
  enum class Role {
    unused,
    number,       // goes into its channel, times its factor, which makes its unit SI
    time,         // of more digits than a double has: the clock's text
    nanoseconds,  // the clock's other text
    fixed_text    // says which joint is meant, and must not change
  };

  std::string name;  // as written
  Role role = Role::unused;
  int channel = -1;
  double factor = 1;
  std::string text{};  // the fixed one
};

struct LogHeading {
  LogLayout layout;
  std::vector<LogColumn> columns;
  char separator = ',';
  CsvClock clock{};
  bool has_nanoseconds = false;  // in a column of their own

  // Times are read as text, and the first one is subtracted from them.
  bool has_exact_time() const { return has_nanoseconds || clock.origin; }
  // By channel, as written: what messages call a column.
  std::vector<std::string> channel_names() const;
};

// Reads "t, q1 [deg], q_elbow, tau1, …" as docs/csv.md has it; `first_row` is the line below it. What is wrong
// (missing, twice, unknown unit) goes into `diagnostics`, and so does what is not used. Torques may be missing, and are
// not read, if `torques` is false.
LogHeading read_heading(const std::string& line, const std::string& first_row, const Place& place,
                        const Mechanism& mechanism, bool torques, Diagnostics& diagnostics);

}  // namespace flatdyn
