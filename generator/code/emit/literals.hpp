// SPDX-License-Identifier: GPL-2.0-or-later
// Conversion of exact constants to decimal literals of the nearest double.
#pragma once

#include <string>

#include "graph/rational.hpp"

namespace flatdyn {

// The nearest double, correctly rounded (half to even) from the exact value, subnormals included. Throws Failure(input)
// if the value is beyond double's range, or so small that it would become zero.
double nearest_double(const Rational& value);

// The shortest decimal that reads back as `value`, always in floating-point form: "0.0825", "2.0", "1.5e-07".
// Independent of the locale.
std::string decimal_literal(double value);

inline std::string decimal_literal(const Rational& value) { return decimal_literal(nearest_double(value)); }

// The nearest double rounded to float, as a cast of a double literal gives it. Throws Failure(input) if it is beyond
// float's range.
float float_of(const Rational& value);

// The shortest decimal that reads back as that float, with its suffix: "0.0825f".
std::string float_literal(const Rational& value);

}  // namespace flatdyn
