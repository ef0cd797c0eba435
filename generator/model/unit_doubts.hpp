// SPDX-License-Identifier: GPL-2.0-or-later
// Numbers that make sense in another unit: angles in degrees, lengths in millimetres. One rule and one way to ask for
// robot files, scenes, trajectories, simulations and logs. Nothing is changed: what is said are warnings.
#pragma once

#include "model/parts.hpp"

namespace flatdyn {

// A joint that has turned so far, or may turn so far, is asked about: rad.
inline constexpr double kManyTurns = 50;

// A constant angle, rad, beyond a whole turn. Expressions in pi were meant in radians.
bool may_be_degrees(const Number& angle);

// A position, rad, of a joint that turns. One within the joint's limits is expected. Without limits it is odd beyond a
// whole turn; where the joint turns without end, if it is a whole multiple of 15, or beyond kManyTurns.
bool may_be_degrees(const Number& position, const Limits& limits, bool continuous);

// A limit, rad, of such a position: beyond kManyTurns, or a whole multiple of 15 other than 0. Beyond 1e4 it stands for
// no limit.
bool limit_may_be_degrees(const Number& limit);

// "90 rad is 14 turns; were degrees meant?"
std::string degrees_question(const Number& angle);

// The angle, rad, of so many degrees, as text: "pi/2" with quotes if it is a multiple of pi/12 and expressions are
// allowed, else the nearest double.
enum class AngleText { decimal, expression };
std::string radians_text(const Number& degrees, AngleText form);

// This is the hint for a file that has the key `angles`.
std::string degrees_hint(const Number& angle);

// The kind by which these warnings are told together.
inline constexpr const char *kAngleDoubts = "angles that may be in degrees",
                            *kLimitDoubts = "limits that may be in degrees",
                            *kLengthDoubts = "lengths that may be in millimetres";

}  // namespace flatdyn
