// SPDX-License-Identifier: GPL-2.0-or-later
// The rounding of generated code's scalars: IEEE 754, to nearest, subnormals included.
#pragma once

#include <string>

#include "robot/model/rounded_up.hpp"

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

// The digits of bounds in certificates, and a bound's text in so many.
inline constexpr int kBoundDigits = 4;
std::string bound_text(double value);

}  // namespace flatdyn
