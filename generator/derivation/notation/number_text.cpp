// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/notation/number_text.hpp"

#include <fmt/format.h>

#include <sstream>

#include "derivation/notation/exact_text.hpp"
#include "robot/model/field_mechanism.hpp"

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

// The number over pi, if that is rational.
std::optional<GiNaC::numeric> turns_of(const Number& number) {
  const Number turns = (number / GiNaC::Pi).expand();
  if (number.is_zero() || !is_rational(turns)) return std::nullopt;
  return GiNaC::ex_to<GiNaC::numeric>(turns);
}

}  // namespace

std::string plain_number_text(const Number& number, int digits) {
  if (const std::optional<GiNaC::numeric> turns = turns_of(number)) return multiple_of_pi(*turns);
  const double value = nearest_double(number);
  return digits >= 17 ? fmt::format("{}", value) : fmt::format("{:.{}g}", value, digits);
}

std::string exact_number_text(const Number& number) {
  if (const std::optional<GiNaC::numeric> turns = turns_of(number)) return multiple_of_pi(*turns);
  if (!is_rational(number)) return plain_number_text(number, kRoundedDigits) + "...";
  const Rational exact = to_rational(number);
  if (const std::optional<std::string> finite = finite_decimal(exact)) return *finite;
  return is_short_fraction(exact) ? exact.str() : rounded_decimal(exact, kRoundedDigits) + "...";
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
