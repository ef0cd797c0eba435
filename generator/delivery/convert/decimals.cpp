// SPDX-License-Identifier: GPL-2.0-or-later
#include "delivery/convert/decimals.hpp"

#include <sstream>

namespace flatdyn {

namespace {

constexpr int kLongestDecimal = 60;  // places behind the point that are written in full

// The fewest places behind the point with which a rational is written in full; -1 if they are too many.
int places_of(const GiNaC::numeric& a) {
  GiNaC::numeric scaled = a;
  for (int places = 0; places <= kLongestDecimal; ++places) {
    if (scaled.is_integer()) return places;
    scaled = scaled.mul(10);
  }
  return -1;
}

std::string text_of(const GiNaC::numeric& integer) {
  std::ostringstream text;
  text << integer;
  return text.str();
}

// Digits with a point before the last `places` of them: "425", 3 → "0.425".
std::string with_point(std::string digits, int places) {
  constexpr int kMostZeros = 6;  // before the first digit; smaller numbers have an exponent
  const int count = static_cast<int>(digits.size());
  if (places - count >= kMostZeros) {
    const std::string exponent = std::to_string(places - count + 1);
    const std::string rest = digits.substr(1);
    return digits.substr(0, 1) + (rest.empty() ? "" : "." + rest) + "e-" + exponent;
  }
  if (places == 0) return digits;
  if (count <= places) digits.insert(0, static_cast<std::size_t>(places - count + 1), '0');
  return digits.insert(digits.size() - static_cast<std::size_t>(places), 1, '.');
}

}  // namespace

bool is_short_decimal(const Number& a) { return is_rational(a) && places_of(GiNaC::ex_to<GiNaC::numeric>(a)) >= 0; }

std::string decimal_text(const Number& a) {
  if (!is_short_decimal(a)) return to_decimal(a, kWrittenDigits);
  const auto& number = GiNaC::ex_to<GiNaC::numeric>(a);
  const int places = places_of(number);
  const GiNaC::numeric digits = GiNaC::abs(number).mul(GiNaC::pow(GiNaC::numeric(10), GiNaC::numeric(places)));
  return (number.is_negative() ? "-" : "") + with_point(text_of(digits), places);
}

int twelfths_of_pi(const Number& angle) {
  const Number twelfths = Number(12 * angle / GiNaC::Pi).expand();
  if (!twelfths.info(GiNaC::info_flags::integer)) return 0;
  return GiNaC::ex_to<GiNaC::numeric>(twelfths).to_int();
}

}  // namespace flatdyn
