// SPDX-License-Identifier: GPL-2.0-or-later
// How the scalars of generated code round: IEEE 754, to nearest, subnormals included.
#pragma once

#include <string>

namespace flatdyn {

struct RoundingFormat {
  std::string scalar;      // "double"
  std::string gappa;       // "float<ieee_64, ne>"
  int precision = 53;      // bits of a significand
  int last_place = -1074;  // exponent of the last bit of a subnormal
  double most = 0;         // results up to this one do not overflow

  // Largest rounding error of results that are no larger than this: half a unit of their last place.
  double half_ulp(double largest) const;
  // The scalar's value of a literal of the text, which is a double.
  double rounded(double literal) const;
  // The largest of its values that is no larger in size.
  double toward_zero(double value) const;
};

// Of "double" or "float".
const RoundingFormat& rounding_format(const std::string& scalar);

// Covers the roundings of the bounds themselves, which are sums and products of positive doubles.
inline constexpr double kUpward = 1 + 1e-9;

// A number of four decimal digits that is larger by a few roundings at least, for people and for Gappa; and its text.
double rounded_up(double value);
std::string four_digits(double value);

}  // namespace flatdyn
