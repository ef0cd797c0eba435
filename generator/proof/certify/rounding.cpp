// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/certify/rounding.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace flatdyn {

double RoundingFormat::half_ulp(double largest) const {
  if (!(largest > 0)) return 0;
  const int last = std::max(std::ilogb(largest) - (precision - 1), last_place);
  return std::max(std::ldexp(1.0, last - 1), std::numeric_limits<double>::denorm_min());
}

double RoundingFormat::rounded(double literal) const {
  return scalar == "float" ? static_cast<double>(static_cast<float>(literal)) : literal;
}

double RoundingFormat::toward_zero(double value) const {
  const double nearest = rounded(value);
  if (std::abs(nearest) <= std::abs(value)) return nearest;
  return static_cast<double>(std::nextafter(static_cast<float>(nearest), 0.0F));
}

const RoundingFormat& rounding_format(const std::string& scalar) {
  static const RoundingFormat in_double{"double", "float<ieee_64, ne>", 53, -1074, 0x1p1023};
  static const RoundingFormat in_float{"float", "float<ieee_32, ne>", 24, -149, 0x1p127};
  return scalar == "float" ? in_float : in_double;
}

std::string bound_text(double value) { return fmt::format("{:.{}g}", value, kBoundDigits); }

}  // namespace flatdyn
