// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/notation/exact_text.hpp"

#include <algorithm>

#include "flatdyn/reference/mpfr_real.hpp"

namespace flatdyn {

std::optional<std::string> finite_decimal(const Rational& number) {
  constexpr std::size_t kMostPlaces = 60;
  Rational scaled = abs(number);
  std::size_t places = 0;
  for (; denominator(scaled) != 1; ++places) {
    if (places == kMostPlaces) return std::nullopt;
    scaled *= 10;
  }
  std::string digits = numerator(scaled).get_str();
  if (digits.size() <= places) digits.insert(0, places + 1 - digits.size(), '0');
  if (places > 0) digits.insert(digits.size() - places, ".");
  return (number < 0 ? "-" : "") + digits;
}

bool is_short_fraction(const Rational& number) {
  constexpr std::size_t kMostCharacters = 50;
  return number.str().size() <= kMostCharacters;
}

std::string rounded_decimal(const Rational& number, int digits) {
  std::string decimal = to_real<reference::Digits100>(number).str(digits);
  decimal.erase(std::remove(decimal.begin(), decimal.end(), '+'), decimal.end());
  return decimal;
}

}  // namespace flatdyn
