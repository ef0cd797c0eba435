// SPDX-License-Identifier: GPL-2.0-or-later
#include "symbolic/notation/combination_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <sstream>
#include <vector>

#include "model/field_mechanism.hpp"
#include "symbolic/notation/exact_text.hpp"

namespace flatdyn {
namespace {

constexpr int kExact = 0;  // as a number of digits: exact

std::string printed(const Number& e) {
  std::ostringstream text;
  text << e;
  return text.str();
}

// A finite decimal as "0.425", another rational as a fraction, "1/3".
std::string exact_text(const Number& magnitude) {
  return finite_decimal(to_rational(magnitude)).value_or(printed(magnitude));
}

std::string number_text(const Number& magnitude, int digits) {
  if (digits == kExact && is_rational(magnitude)) return exact_text(magnitude);
  const double number = nearest_double(magnitude);
  // The shortest text of the double.
  if (digits >= std::numeric_limits<double>::max_digits10) return fmt::format("{}", number);
  return fmt::format("{:.{}g}", number, digits);
}

// A summand with its sign kept apart.
struct Summand {
  bool negative = false;
  std::string body;
};

std::string joined_summands(const std::vector<Summand>& pieces) {
  std::string text;
  for (const Summand& piece : pieces) {
    const char* sign = piece.negative ? "-" : "+";
    if (text.empty()) {
      text = (piece.negative ? "-" : "") + piece.body;
    } else {
      text += fmt::format(" {} {}", sign, piece.body);
    }
  }
  return text.empty() ? "0" : text;
}

std::string sum_text(const Number& polynomial, int digits);

std::string factor_with_digits(const Number& factor, int digits) {
  if (!GiNaC::is_a<GiNaC::power>(factor)) {
    return GiNaC::is_a<GiNaC::add>(factor) ? "(" + sum_text(factor, digits) + ")" : printed(factor);
  }
  const Number &base = factor.op(0), &exponent = factor.op(1);
  return factor_with_digits(base, digits) + "^" + printed(exponent);
}

Summand term_piece(const Number& term, int digits) {
  Number number = 1;
  std::vector<std::string> factors;
  const auto add = [&](const Number& factor) {
    if (GiNaC::is_a<GiNaC::numeric>(factor)) {
      number *= factor;
    } else {
      factors.push_back(factor_with_digits(factor, digits));
    }
  };
  if (GiNaC::is_a<GiNaC::mul>(term)) {
    for (const Number& factor : term) add(factor);
  } else {
    add(term);
  }
  std::sort(factors.begin(), factors.end());
  const bool negative = number.info(GiNaC::info_flags::negative);
  if (negative) number = -number;
  if (!number.is_equal(1) || factors.empty()) factors.insert(factors.begin(), number_text(number, digits));
  return {negative, fmt::format("{}", fmt::join(factors, " "))};
}

std::vector<Summand> pieces_of(const Number& polynomial, int digits) {
  std::vector<Summand> pieces;
  if (GiNaC::is_a<GiNaC::add>(polynomial)) {
    for (const Number& term : polynomial) pieces.push_back(term_piece(term, digits));
  } else if (!polynomial.is_zero()) {
    pieces.push_back(term_piece(polynomial, digits));
  }
  std::sort(pieces.begin(), pieces.end(), [](const Summand& a, const Summand& b) {
    return std::tie(a.negative, a.body) < std::tie(b.negative, b.body);
  });
  return pieces;
}

std::string sum_text(const Number& polynomial, int digits) {
  return joined_summands(pieces_of(polynomial.expand(), digits));
}

// The coefficient before a parameter's name, with its sign kept apart; empty for 1.
Summand coefficient_piece(const Number& coefficient, int digits) {
  const Number whole = coefficient.normal(), below = whole.denom(), above = whole.numer().expand();
  if (is_rational(whole) || is_rational(below)) {
    const std::vector<Summand> pieces = pieces_of(whole.expand(), digits);
    if (pieces.size() == 1) return {pieces[0].negative, pieces[0].body == "1" ? "" : pieces[0].body};
    return {false, "(" + joined_summands(pieces) + ")"};
  }
  const std::vector<Summand> pieces = pieces_of(above, digits);
  const std::string divisor = "/(" + sum_text(below, digits) + ")";
  if (pieces.size() == 1) return {pieces[0].negative, pieces[0].body + divisor};
  return {false, "(" + joined_summands(pieces) + ")" + divisor};
}

}  // namespace

std::string coefficient_text(const Number& coefficient) {
  const Summand piece = coefficient_piece(coefficient, kExact);
  return (piece.negative ? "-" : "") + (piece.body.empty() ? "1" : piece.body);
}

std::string combination_text(const BaseParameters& base, int k, int digits) {
  const int kept = base.columns[static_cast<std::size_t>(k)];
  std::vector<Summand> pieces = {{false, parameter_name(kept)}};
  for (const auto& [index, coefficient] : base.combination[static_cast<std::size_t>(k)]) {
    if (index == kept) continue;
    const Summand factor = coefficient_piece(coefficient, digits);
    pieces.push_back({factor.negative, factor.body + (factor.body.empty() ? "" : " ") + parameter_name(index)});
  }
  return joined_summands(pieces);
}

}  // namespace flatdyn
