// SPDX-License-Identifier: GPL-2.0-or-later
// Exact numbers → text of a robot file.
#pragma once

#include <string>

#include "robot/model/number.hpp"

namespace flatdyn {

// The digits of a number that is no finite decimal, or a very long one.
inline constexpr int kWrittenDigits = 25;

// Whether a number without symbols is a decimal that is written in full.
bool is_short_decimal(const Number& a);

// The decimal of a number without symbols: exact if it is short, else rounded to kWrittenDigits: "0.425", "1.5e-07".
std::string decimal_text(const Number& a);

// The twelfths of pi that an angle is; 0 if it is no whole number of them, or no turn.
int twelfths_of_pi(const Number& angle);

}  // namespace flatdyn
