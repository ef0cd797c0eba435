// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/scene.hpp"

#include <stdexcept>

namespace flatdyn {

std::optional<ErrorBudget> error_budget(const std::string& text) {
  constexpr double kLargest = 1e30, kWhole = 100;
  const bool relative = !text.empty() && text.back() == '%';
  try {
    const double value = nearest_double(exact_decimal(relative ? text.substr(0, text.size() - 1) : text));
    if (value < 0 || value > (relative ? kWhole : kLargest)) return std::nullopt;
    return ErrorBudget{relative ? value / kWhole : value, relative, text};
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

}  // namespace flatdyn
