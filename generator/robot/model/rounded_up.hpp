// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace flatdyn {

// Covers the rounding errors of bounds that are sums and products of positive doubles.
inline constexpr double kRoundingMargin = 1 + 1e-9;

// A number of so many decimal digits (1 to 17) that exceeds `value` by at least a few rounding errors, so that a bound
// that people or Gappa read stays a bound. 0 for a value that is not positive.
double rounded_up(double value, int digits);
// The same from below.
double rounded_down(double value, int digits);

}  // namespace flatdyn
