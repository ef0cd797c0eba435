// SPDX-License-Identifier: GPL-2.0-or-later
// Rational numbers as text, in full.
#pragma once

#include <optional>
#include <string>

#include "graph/rational.hpp"

namespace flatdyn {

// The number as a decimal without exponent, "0.425"; nullopt if that does not end within 60 places.
std::optional<std::string> finite_decimal(const Rational& number);

// Whether the fraction, "355/113", is short enough to be read.
bool is_short_fraction(const Rational& number);

// Rounded to this many significant digits: "0.33333", "1.2e-07".
std::string rounded_decimal(const Rational& number, int digits);

// The digits of numbers that are too long to be written in full; "..." follows them.
inline constexpr int kRoundedDigits = 17;

}  // namespace flatdyn
