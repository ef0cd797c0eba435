// SPDX-License-Identifier: GPL-2.0-or-later
#include "symbolic/notation/number_text.hpp"

#include <fmt/format.h>

#include <sstream>

namespace flatdyn {
namespace {

// A rational multiple of pi: "-8*pi/9".
std::string multiple_of_pi(const GiNaC::numeric& turns) {
  std::ostringstream text;
  if (turns.is_negative()) text << "-";
  const GiNaC::numeric above = GiNaC::abs(turns.numer());
  if (!above.is_equal(1)) text << above << "*";
  text << "pi";
  if (!turns.denom().is_equal(1)) text << "/" << turns.denom();
  return text.str();
}

}  // namespace

std::string plain_number_text(const Number& number, int digits) {
  const Number turns = (number / GiNaC::Pi).expand();
  if (!number.is_zero() && is_rational(turns)) return multiple_of_pi(GiNaC::ex_to<GiNaC::numeric>(turns));
  const double value = nearest_double(number);
  return digits >= 17 ? fmt::format("{}", value) : fmt::format("{:.{}g}", value, digits);
}

std::string factor_text(const Number& factor) {
  constexpr int kShort = 100;
  const std::string decimal = plain_number_text(factor);
  const GiNaC::numeric above = GiNaC::ex_to<GiNaC::numeric>(factor).numer();
  const GiNaC::numeric below = GiNaC::ex_to<GiNaC::numeric>(factor).denom();
  if (exact_decimal(decimal).is_equal(factor) || GiNaC::abs(above) >= kShort || below >= kShort) return decimal;
  return fmt::format("{}/{}", above.to_int(), below.to_int());
}

std::string NumberText::operator()(const Number& number) const {
  if (!has_symbols(number)) return plain_number_text(number, digits_);
  SumFormatter formatter(names_, 0, Notation::text, digits_);
  return formatter.text(names_.readable(number), GroupBy::parameters);
}

std::string NumberText::operator()(const Vec3& vector) const {
  return fmt::format("({}, {}, {})", (*this)(vector[0]), (*this)(vector[1]), (*this)(vector[2]));
}

}  // namespace flatdyn
