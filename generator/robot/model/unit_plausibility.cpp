// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/unit_plausibility.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace flatdyn {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kRounded = 1e-3;  // as a fraction of a turn: 6.2832 and 6.289 count as one turn, too
constexpr double kNoLimit = 1e4;   // rad

bool is_multiple_of_15(const Number& degrees) {
  constexpr int kTwelfth = 15;
  return !degrees.is_zero() && (degrees / kTwelfth).info(GiNaC::info_flags::integer);
}

double size_of(const Number& number) { return std::abs(nearest_double(number)); }

// Not an expression in pi, which is taken as radians, nor one with a symbol.
bool is_plain(const Number& angle) { return !has_symbols(angle) && !angle.has(GiNaC::Pi); }

bool is_beyond_a_turn(double angle) { return angle > kTurn * (1 + kRounded); }

}  // namespace

bool may_be_degrees(const Number& angle) { return is_plain(angle) && is_beyond_a_turn(size_of(angle)); }

bool may_be_degrees(const Number& position, const Limits& limits, bool continuous) {
  if (!may_be_degrees(position)) return false;
  const double size = size_of(position);
  if (limits.lower && limits.upper) {
    return size > std::max(size_of(limits.lower->number), size_of(limits.upper->number));
  }
  return !continuous || size > kManyTurns || is_multiple_of_15(position);
}

bool limit_may_be_degrees(const Number& limit) {
  if (!is_plain(limit)) return false;
  const double size = size_of(limit);
  return size <= kNoLimit && (size > kManyTurns || is_multiple_of_15(limit));
}

std::string degrees_question(const Number& angle) {
  constexpr double kFew = 10;
  const double turns = size_of(angle) / kTurn;
  return fmt::format("{:.6g} rad is {:.{}f} turns; were degrees meant?", nearest_double(angle), turns,
                     turns < kFew ? 1 : 0);
}

std::string radians_text(const Number& degrees, AngleText form) {
  constexpr int kTenTurns = 3600;
  const Number angle = degrees * GiNaC::Pi / 180;
  const bool is_nice = is_multiple_of_15(degrees) && size_of(degrees) <= kTenTurns;
  if (form == AngleText::decimal || !is_nice) return fmt::format("{}", nearest_double(angle));
  const GiNaC::numeric half_turns = GiNaC::ex_to<GiNaC::numeric>(degrees / 180);
  const int above = half_turns.numer().to_int(), below = half_turns.denom().to_int();
  const std::string factor = above == 1 ? "" : above == -1 ? "-" : fmt::format("{}*", above);
  return fmt::format("\"{}pi{}\"", factor, below == 1 ? "" : fmt::format("/{}", below));
}

std::string degrees_hint(const Number& angle) {
  return "if so, write angles = \"deg\" at the top of the file, or " + radians_text(angle, AngleText::expression);
}

}  // namespace flatdyn
