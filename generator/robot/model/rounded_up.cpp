// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/rounded_up.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace flatdyn {

namespace {

// The number as it reads with so many digits.
double read_back(double value, int digits) {
  const std::string text = fmt::format("{:.{}g}", value, digits);
  double read = 0;
  std::from_chars(text.data(), text.data() + text.size(), read);
  return read;
}

// A change of the last digit, or less.
double step_of(int digits) { return 1 + std::pow(10, -digits); }

}  // namespace

// Raises the last digit until the number is large enough, as a rule once.
double rounded_up(double value, int digits) {
  if (!(value > 0)) return 0;
  for (double raised = value;; raised *= step_of(digits)) {
    const double read = read_back(raised, digits);
    if (read >= value * kRoundingMargin) return read;
  }
}

double rounded_down(double value, int digits) {
  if (!(value > 0)) return 0;
  for (double lowered = value;; lowered /= step_of(digits)) {
    const double read = read_back(lowered, digits);
    if (read <= value / kRoundingMargin) return read;
  }
}

}  // namespace flatdyn
