// SPDX-License-Identifier: GPL-2.0-or-later
// Checks for numbers that make sense in another unit: angles in degrees, lengths in millimetres. Robot files, scenes,
// trajectories, simulations and logs share the rules and the questions. They only lead to warnings; nothing is changed.
#pragma once

#include "robot/model/parts.hpp"

namespace flatdyn {

// The positions and limits, rad, beyond which a joint's angle is questioned.
inline constexpr double kManyTurns = 50;

// Whether a constant angle, rad, is beyond a whole turn. Expressions in pi are taken as radians.
bool may_be_degrees(const Number& angle);

// Whether a position, rad, of a revolute joint may be in degrees. A position within the joint's limits is not
// questioned. Without limits it is questioned beyond a whole turn; for a joint that turns without end, if it is a whole
// multiple of 15, or beyond kManyTurns.
bool may_be_degrees(const Number& position, const Limits& limits, bool continuous);

// Whether a limit, rad, of such a position may be in degrees: it is beyond kManyTurns, or a whole multiple of 15 other
// than 0. Beyond 1e4 it means that there is no limit.
bool limit_may_be_degrees(const Number& limit);

// The question in a warning: "90 rad is 14 turns; were degrees meant?"
std::string degrees_question(const Number& angle);

// The angle of this many degrees, in rad, as text: "pi/2" with quotes if it is a multiple of pi/12 and expressions are
// allowed, else the nearest double.
enum class AngleText { decimal, expression };
std::string radians_text(const Number& degrees, AngleText form);

// The hint for a file that has the key `angles`.
std::string degrees_hint(const Number& angle);

// The kinds under which these warnings are grouped.
inline constexpr const char *kAngleWarnings = "angles that may be in degrees",
                            *kLimitWarnings = "limits that may be in degrees",
                            *kLengthWarnings = "lengths that may be in millimetres";

}  // namespace flatdyn
