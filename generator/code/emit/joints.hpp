// SPDX-License-Identifier: GPL-2.0-or-later
// The text about the robot's joints in a header: the table for people, the limits for programs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "code/table.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

// One kind of limit that a joint may have.
struct LimitColumn {
  const char* column;    // heading in the table
  const char* constant;  // name of the emitted array
  const char* meaning;   // comment of the array
  bool is_lower;         // a missing lower limit is minus infinity
  std::optional<Value> Limits::*value;
};

// The kinds of limits that at least one joint of the mechanism has, in a fixed order.
std::vector<LimitColumn> limits_given(const Mechanism& mechanism);

// The value of a number, with as many digits of Pi and roots as matter; nullopt if it depends on a free symbol.
std::optional<Rational> rational_of(const Number& number);

// The entries of the emitted table of one kind of limit; infinite where a joint has none.
std::vector<code::TableEntry> limit_entries(const Mechanism& mechanism, const LimitColumn& kind);

// Lines of the table: index (with closed loops those in q and qd), joint, link, type, unit and the limits given.
std::vector<std::string> joint_table(const Mechanism& mechanism);

}  // namespace flatdyn
