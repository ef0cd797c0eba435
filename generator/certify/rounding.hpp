// SPDX-License-Identifier: GPL-2.0-or-later
// The rounding of generated code's scalars: IEEE 754, to nearest, subnormals included.
#pragma once

#include <string>

namespace flatdyn {

struct RoundingFormat {
  std::string scalar;      // "double"
  std::string gappa;       // "float<ieee_64, ne>"
  int precision = 53;      // bits of the significand
  int last_place = -1074;  // exponent of the last bit of a subnormal
  double most = 0;         // results up to this size do not overflow

  // The largest rounding error of results up to this size: half a unit in their last place.
  double half_ulp(double largest) const;
  // The scalar's value for a literal of the text, which is a double.
  double rounded(double literal) const;
  // The largest of the scalar's values that is no larger in absolute value.
  double toward_zero(double value) const;
};

// The format of "double" or "float".
const RoundingFormat& rounding_format(const std::string& scalar);

// Covers the rounding errors of the bounds themselves, which are sums and products of positive doubles.
inline constexpr double kUpward = 1 + 1e-9;

// A number of four decimal digits that exceeds `value` by at least a few rounding errors, for people and for Gappa; and
// its text.
double rounded_up(double value);
std::string four_digits(double value);

}  // namespace flatdyn
