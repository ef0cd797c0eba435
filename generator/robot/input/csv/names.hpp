// SPDX-License-Identifier: GPL-2.0-or-later
// The name of a column says this by itself. The headings that are read are listed in docs/csv.md.
#pragma once

#include <optional>
#include <string>

#include "graph/graph.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

enum class CsvQuantity {
  time,
  seconds,      // of a time that is in two columns
  nanoseconds,  // the other one
  q,
  qd,
  qdd,
  tau,
  temperature,  // of a joint's drive, °C
  h_e,
  qd_r,
  qdd_r,
  pi_b,
  weights,    // of products with derivatives
  direction,  // likewise
  h,          // the length of a step in time, s
  qd_end,     // joint rates at its end
  g_b,        // gravity in the axes of a floating base
  pose,       // of a floating base: position in the world, then its unit quaternion w, x, y, z
  imu,        // of a floating base: specific force, then angular velocity, in the axes of a link fixed to it
  symbol,     // a free symbol of the robot
  joint_name  // not a number: which joint an array's entry belongs to
};

// Where several ways to write a quantity are in one file, the one that comes first here counts.
enum class CsvStyle {
  named,       // q1, q_elbow, q[0], tau_3, t, time
  plot,        // __time
  message,     // /joint_states/elbow/position, header.stamp
  array,       // position[0], field.position0
  timestamp,   // timestamp
  message_bag  // %time
};

struct CsvName {
  std::string name;  // as written, without unit and quotation marks
  std::string unit;  // as written in brackets
  std::optional<CsvQuantity> quantity{};
  CsvStyle style = CsvStyle::named;
  // Which entry of the quantity: by its number as written, counted from 0 or from 1; or, where the name of a joint, a
  // force's letter or a symbol says it, the entry itself, from 0.
  std::optional<int> number{}, entry{};
  std::string prefix{};  // of an array, what stands before "position"
};

// How many entries a quantity has for this robot; 0 for those number depends on the function.
int length_of(CsvQuantity quantity, const Mechanism& mechanism);
// The joint that entry k of a joint's quantity belongs to.
const Body& joint_of(CsvQuantity quantity, int entry, const Mechanism& mechanism);
// The name of that entry behind "q_", "qd_", …: the joint's, or "JOINT.qw" or "JOINT.wx" of a spherical joint.
std::string entry_name_of(CsvQuantity quantity, int entry, const Mechanism& mechanism);
bool is_of_joints(CsvQuantity quantity);
// "q" of the columns q1, …
std::string stem_of(CsvQuantity quantity);
// The name of a column that has no number: "base_vx", "base_dwz" or "base_nx" about a floating base, "h"; empty for
// other entries.
std::string base_name_of(CsvQuantity quantity, int entry, const Mechanism& mechanism);
// The quantity of a column with an input of functions, and its name by number: "q1", "base_vx", "qd7", "m1".
CsvQuantity quantity_of(InputKind kind);
std::string column_name(const Input& input, const Mechanism& mechanism);
// The entry of a joint's quantity that belongs to a joint.
std::optional<int> entry_of_joint(CsvQuantity quantity, const std::string& joint, const Mechanism& mechanism);

CsvName read_csv_name(const std::string& entry, const Mechanism& mechanism);

}  // namespace flatdyn
