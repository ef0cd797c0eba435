// SPDX-License-Identifier: GPL-2.0-or-later
#include "model/rounded_up.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace flatdyn {

// Raises the last digit until the number is large enough, as a rule once.
double rounded_up(double value, int digits) {
  if (!(value > 0)) return 0;
  const double step = 1 + std::pow(10, -digits);
  for (double raised = value;; raised *= step) {
    const std::string text = fmt::format("{:.{}g}", raised, digits);
    double read = 0;
    std::from_chars(text.data(), text.data() + text.size(), read);
    if (read >= value * kRoundingMargin) return read;
  }
}

}  // namespace flatdyn
