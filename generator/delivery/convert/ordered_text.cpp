// SPDX-License-Identifier: GPL-2.0-or-later
#include "delivery/convert/ordered_text.hpp"

#include <algorithm>
#include <sstream>
#include <tuple>
#include <vector>

namespace flatdyn {

namespace {

std::string printed(const Number& atom) {
  if (atom.is_equal(GiNaC::Pi)) return "pi";
  std::ostringstream text;
  text << atom;
  return text.str();
}

std::string in_parentheses(const std::string& text) { return "(" + text + ")"; }

std::string power_text(const Number& power) {
  const Number &base = power.op(0), &exponent = power.op(1);
  if (exponent.is_equal(Number(1) / 2)) return "sqrt" + in_parentheses(ordered_text(base));
  const bool is_name = GiNaC::is_a<GiNaC::symbol>(base) || GiNaC::is_a<GiNaC::constant>(base);
  const std::string of = is_name ? ordered_text(base) : in_parentheses(ordered_text(base));
  return of + "^" + (exponent.info(GiNaC::info_flags::posint) ? printed(exponent) : in_parentheses(printed(exponent)));
}

std::string factor_text(const Number& factor) {
  return GiNaC::is_a<GiNaC::add>(factor) ? in_parentheses(ordered_text(factor)) : ordered_text(factor);
}

// A term without its sign.
struct PrintedTerm {
  bool is_negative = false;
  std::string factors, coefficient;  // one of them may be empty

  std::string text() const { return coefficient + (coefficient.empty() || factors.empty() ? "" : "*") + factors; }
};

PrintedTerm term_of(const Number& term) {
  Number coefficient = 1;
  std::vector<std::string> factors;
  const auto take = [&](const Number& factor) {
    if (GiNaC::is_a<GiNaC::numeric>(factor)) {
      coefficient *= factor;
    } else {
      factors.push_back(factor_text(factor));
    }
  };
  if (GiNaC::is_a<GiNaC::mul>(term)) {
    for (std::size_t k = 0; k < term.nops(); ++k) take(term.op(k));
  } else {
    take(term);
  }
  std::sort(factors.begin(), factors.end());
  PrintedTerm result;
  result.is_negative = coefficient.info(GiNaC::info_flags::negative);
  if (result.is_negative) coefficient = -coefficient;
  for (const std::string& factor : factors) result.factors += (result.factors.empty() ? "" : "*") + factor;
  if (!coefficient.is_equal(1) || factors.empty()) result.coefficient = printed(coefficient);
  return result;
}

}  // namespace

std::string ordered_text(const Number& expression) {
  if (GiNaC::is_a<GiNaC::power>(expression)) return power_text(expression);
  if (GiNaC::is_a<GiNaC::function>(expression)) {
    return GiNaC::ex_to<GiNaC::function>(expression).get_name() + in_parentheses(ordered_text(expression.op(0)));
  }
  const bool is_sum = GiNaC::is_a<GiNaC::add>(expression);
  if (!is_sum && !GiNaC::is_a<GiNaC::mul>(expression)) return printed(expression);
  std::vector<PrintedTerm> terms;
  for (std::size_t k = 0; is_sum && k < expression.nops(); ++k) terms.push_back(term_of(expression.op(k)));
  if (!is_sum) terms.push_back(term_of(expression));
  std::sort(terms.begin(), terms.end(), [](const PrintedTerm& a, const PrintedTerm& b) {
    return std::tie(a.is_negative, a.factors, a.coefficient) < std::tie(b.is_negative, b.factors, b.coefficient);
  });
  std::string text;
  for (const PrintedTerm& term : terms) {
    const char* const sign = term.is_negative ? (text.empty() ? "-" : " - ") : (text.empty() ? "" : " + ");
    text += sign + term.text();
  }
  return text;
}

}  // namespace flatdyn
