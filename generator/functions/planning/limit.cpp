// SPDX-License-Identifier: GPL-2.0-or-later
#include "functions/planning/limit.hpp"

#include <algorithm>
#include <stdexcept>

#include "base/diagnostics/characters.hpp"
#include "robot/model/number.hpp"

namespace flatdyn {
namespace {

constexpr double kMostSeconds = 86400, kMostCandidates = 1e6;

}  // namespace

std::optional<SearchLimit> search_limit(const std::string& text) {
  if (text.empty()) return std::nullopt;
  const bool is_time = text.back() == 's';
  const std::string digits = is_time ? text.substr(0, text.size() - 1) : text;
  if (!is_time && !std::all_of(digits.begin(), digits.end(), is_digit)) return std::nullopt;
  try {
    const double value = nearest_double(exact_decimal(digits));
    if (value <= 0 || value > (is_time ? kMostSeconds : kMostCandidates)) return std::nullopt;
    if (is_time) return SearchLimit{std::nullopt, value};
    return SearchLimit{static_cast<int>(value), std::nullopt};
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

}  // namespace flatdyn
