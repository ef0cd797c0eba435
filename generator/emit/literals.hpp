// SPDX-License-Identifier: GPL-2.0-or-later
// Exact constants → decimal literals of the nearest double.
#pragma once

#include <string>

#include "graph/rational.hpp"

namespace flatdyn {

// Correctly rounded (half to even), straight from the exact value, subnormals included. Throws Failure(input) if the
// value is beyond double's range, or so small that it would become zero.
double nearest_double(const Rational& value);

// The shortest decimal that reads back as `value`, always of floating type: "0.0825", "2.0", "1.5e-07". Knows no
// locale.
std::string decimal_literal(double value);

inline std::string decimal_literal(const Rational& value) { return decimal_literal(nearest_double(value)); }

// The nearest double rounded to float, as a cast from the literal of a double gives it. Throws Failure(input) if it is
// beyond float's range.
float float_of(const Rational& value);

// The shortest decimal that reads back as that float, with its suffix: "0.0825f".
std::string float_literal(const Rational& value);

}  // namespace flatdyn
