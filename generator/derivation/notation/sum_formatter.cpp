// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/notation/sum_formatter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <utility>

#include "derivation/notation/exact_text.hpp"
#include "derivation/notation/latex.hpp"
#include "robot/model/field_mechanism.hpp"

namespace flatdyn {
namespace {

bool is_symbol(const Factor& factor) { return factor.kind <= FactorKind::gravity; }

bool is_key(const Factor& factor, GroupBy group_by) {
  const bool parameter = factor.kind == FactorKind::dynamic || factor.kind == FactorKind::gear;
  return group_by == GroupBy::parameters ? parameter : factor.kind >= FactorKind::gravity;
}

// Groups by parameters are ordered by mass and inertia first, by gear ratio second.
using GroupKey = std::pair<Monomial, Monomial>;

GroupKey group_key(const Monomial& monomial, GroupBy group_by) {
  GroupKey key;
  for (const auto& power : monomial) {
    if (!is_key(power.first, group_by)) continue;
    (power.first.kind == FactorKind::gear ? key.second : key.first).insert(power);
  }
  return key;
}

Monomial without(const Monomial& monomial, GroupBy group_by) {
  Monomial rest = monomial;
  std::erase_if(rest, [&](const auto& power) { return is_key(power.first, group_by); });
  return rest;
}

int degree_in_motion(const Monomial& monomial) {
  int degree = 0;
  for (const auto& [factor, exponent] : monomial) degree += factor.kind > FactorKind::gravity ? exponent : 0;
  return degree;
}

bool is_of_parameters(const ReadableSum& sum) {
  return std::all_of(sum.begin(), sum.end(), [](const auto& term) { return degree_in_motion(term.first) == 0; });
}

void put_positive_term_first(std::vector<SignedTerm>& terms) {
  const auto first = std::find_if(terms.begin(), terms.end(), [](const SignedTerm& term) { return !term.negative; });
  if (first != terms.end()) std::rotate(terms.begin(), first, first + 1);
}

// The largest number that divides all coefficients: gcd of numerators over lcm of denominators; negative if all
// coefficients are.
Rational content(const ReadableSum& sum) {
  Rational::Integer above = 0, below = 1;
  bool all_negative = true;
  for (const auto& [monomial, coefficient] : sum) {
    above = gcd(above, numerator(coefficient));
    below = lcm(below, denominator(coefficient));
    all_negative = all_negative && coefficient < 0;
  }
  return Rational(all_negative ? Rational::Integer(-above) : above, below);
}

// Whether factoring out the divisor leaves small whole numbers, so that it is worth doing.
bool leaves_small_numbers(const ReadableSum& sum, const Rational& divisor) {
  return std::all_of(sum.begin(), sum.end(), [&](const auto& term) { return abs(term.second / divisor) <= 99; });
}

}  // namespace

SumFormatter::SumFormatter(const FactorNames& names, int joints, Notation notation, int digits,
                           std::vector<CoordinateMultiple> further_angles)
    : names_(names), joints_(joints), notation_(notation), digits_(digits), further_angles_(std::move(further_angles)) {
  static const std::set<std::string> kOurs = {"c", "s", "d", "q", "qd", "qdd"};
  long_names_ = std::any_of(names.all().begin(), names.all().end(), [](const std::string& name) {
    const std::size_t underscore = name.find('_');
    const bool numbered = underscore != std::string::npos && underscore + 1 < name.size() &&
                          std::isdigit(static_cast<unsigned char>(name[underscore + 1])) != 0;
    return numbered && kOurs.contains(name.substr(0, underscore));
  });
}

std::string SumFormatter::subscript(const std::vector<int>& indices, int count) const {
  const bool latex = notation_ == Notation::latex;
  const std::string separator = count < 10 ? "" : latex ? "," : "_";
  std::string text;
  for (const int index : indices) text += (text.empty() ? "" : separator) + std::to_string(index + 1);
  return latex ? "_{" + text + "}" : "_" + text;
}

std::string SumFormatter::coordinate(const std::string& letter, int joint) const {
  if (notation_ == Notation::text) return letter + subscript({joint});
  if (letter == "qd") return "\\dot{q}" + subscript({joint});
  if (letter == "qdd") return "\\ddot{q}" + subscript({joint});
  if (letter == "tau") return "\\tau" + subscript({joint});
  return letter + subscript({joint});
}

std::string SumFormatter::fraction(const Rational& magnitude) const {
  const std::string above = numerator(magnitude).get_str(), below = denominator(magnitude).get_str();
  return notation_ == Notation::latex ? "\\frac{" + above + "}{" + below + "}" : above + "/" + below;
}

std::string SumFormatter::decimal(const std::string& text) const {
  return notation_ == Notation::latex ? latex_number(text) : text;
}

std::string SumFormatter::number(const Rational& magnitude, bool with_symbols) {
  const bool is_whole = denominator(magnitude) == 1;
  const bool is_small = !is_whole && denominator(magnitude) <= 12 && numerator(magnitude) < 100;
  if (is_small && with_symbols) return fraction(magnitude);
  const std::string rounded = rounded_decimal(magnitude, digits_ == kExactDigits ? kRoundedDigits : digits_);
  if (exact_decimal(rounded).is_equal(GiNaC::numeric(magnitude.str().c_str()))) return decimal(rounded);
  if (is_small) return fraction(magnitude);
  if (digits_ != kExactDigits) {
    rounded_ = true;
    return decimal(rounded);
  }
  if (const std::optional<std::string> finite = finite_decimal(magnitude)) return *finite;
  if (is_short_fraction(magnitude)) return fraction(magnitude);
  rounded_ = true;
  return decimal(rounded) + (notation_ == Notation::latex ? "\\ldots" : "...");
}

// The multiples of the coordinates in a factor's angle.
std::vector<Rational> SumFormatter::multiples_of_coordinates(const Factor& factor) const {
  const auto n = static_cast<std::size_t>(joints_);
  std::vector<Rational> multiples(factor.angle.begin(), factor.angle.begin() + static_cast<std::ptrdiff_t>(n));
  for (std::size_t a = n; a < factor.angle.size(); ++a) {
    const CoordinateMultiple& angle = further_angles_[a - n];
    multiples[static_cast<std::size_t>(angle.position)] += factor.angle[a] * to_rational(angle.factor);
  }
  return multiples;
}

std::string SumFormatter::trigonometric(const Factor& factor) {
  const bool sine = factor.kind == FactorKind::sine, latex = notation_ == Notation::latex;
  const std::vector<Rational> multiples = multiples_of_coordinates(factor);
  const bool plain =
      std::all_of(multiples.begin(), multiples.end(), [](const Rational& k) { return k == 0 || k == 1; });
  if (plain && !long_names_) {
    std::vector<int> joints;
    for (std::size_t i = 0; i < multiples.size(); ++i) {
      if (multiples[i] != 0) joints.push_back(static_cast<int>(i));
    }
    return (sine ? "s" : "c") + subscript(joints);
  }
  std::vector<SignedTerm> angles;
  for (std::size_t i = 0; i < multiples.size(); ++i) {
    const Rational& k = multiples[i];
    if (k == 0) continue;
    const std::string times = abs(k) == 1 ? "" : number(abs(k), true) + " ";
    angles.push_back({k < 0, times + coordinate("q", static_cast<int>(i))});
  }
  return std::string(latex ? "\\" : "") + (sine ? "sin(" : "cos(") + joined(angles) + ")";
}

std::string SumFormatter::factor(const Factor& factor) {
  if (factor.is_trigonometric()) return trigonometric(factor);
  if (factor.kind == FactorKind::coordinate) return coordinate(long_names_ ? "q" : "d", factor.index);
  return notation_ == Notation::latex ? latex_name(names_.name(factor)) : names_.name(factor);
}

std::string SumFormatter::monomial(const Monomial& monomial) {
  std::string text;
  for (const auto& [base, exponent] : monomial) {
    text += (text.empty() ? "" : " ") + factor(base);
    if (exponent == 1) continue;
    const std::string power = std::to_string(exponent);
    text += power.size() > 1 && notation_ == Notation::latex ? "^{" + power + "}" : "^" + power;
  }
  return text;
}

std::string SumFormatter::product(const Rational& magnitude, const Monomial& factors) {
  if (factors.empty()) return number(magnitude, false);
  if (magnitude == 1) return monomial(factors);
  const bool with_symbols =
      std::any_of(factors.begin(), factors.end(), [](const auto& power) { return is_symbol(power.first); });
  return number(magnitude, with_symbols) + " " + monomial(factors);
}

// The terms with constants first, then by degree in the joints' motion.
std::vector<SignedTerm> SumFormatter::sorted_terms(const ReadableSum& sum) {
  std::vector<std::pair<Monomial, Rational>> terms(sum.begin(), sum.end());
  std::stable_sort(terms.begin(), terms.end(),
                   [](const auto& a, const auto& b) { return degree_in_motion(a.first) < degree_in_motion(b.first); });
  std::vector<SignedTerm> pieces;
  for (const auto& [factors, coefficient] : terms) {
    pieces.push_back({coefficient < 0, product(abs(coefficient), factors)});
  }
  return pieces;
}

SignedTerm SumFormatter::group(const Monomial& common, const ReadableSum& rest, GroupBy group_by) {
  if (rest.size() == 1) {
    Monomial all = common;
    for (const auto& power : rest.begin()->first) all.insert(power);
    const Rational& coefficient = rest.begin()->second;
    return {coefficient < 0, product(abs(coefficient), all)};
  }
  Rational divisor = content(rest);
  if (!leaves_small_numbers(rest, divisor)) divisor = divisor < 0 ? -1 : 1;
  ReadableSum quotient = rest;
  for (auto& term : quotient) term.second /= divisor;
  const std::string sum = "(" + joined(sorted_terms(quotient)) + ")";
  const Rational magnitude = abs(divisor);
  if (group_by == GroupBy::parameters) return {divisor < 0, product(magnitude, common) + " " + sum};
  const std::string front = magnitude == 1 ? "" : number(magnitude, true) + " ";
  return {divisor < 0, front + sum + " " + monomial(common)};
}

std::vector<SignedTerm> SumFormatter::pieces(const ReadableSum& sum, GroupBy group_by) {
  std::map<GroupKey, ReadableSum> groups;
  for (const auto& [factors, coefficient] : sum) {
    groups[group_key(factors, group_by)][without(factors, group_by)] += coefficient;
  }
  std::vector<SignedTerm> result;
  for (const auto& [key, rest] : groups) {
    Monomial common = key.first;
    common.insert(key.second.begin(), key.second.end());
    if (common.empty()) {
      const std::vector<SignedTerm> single = sorted_terms(rest);
      result.insert(result.end(), single.begin(), single.end());
    } else {
      result.push_back(group(common, rest, group_by));
    }
  }
  if (positive_first_ && is_of_parameters(sum)) put_positive_term_first(result);
  return result;
}

SignedTerm SumFormatter::times(const std::vector<SignedTerm>& pieces, const std::string& suffix) {
  if (pieces.size() == 1) {
    const SignedTerm& only = pieces.front();
    return {only.negative, only.body == "1" ? suffix : only.body + " " + suffix};
  }
  const bool negative =
      std::all_of(pieces.begin(), pieces.end(), [](const SignedTerm& piece) { return piece.negative; });
  std::vector<SignedTerm> inside = pieces;
  for (SignedTerm& piece : inside) piece.negative = piece.negative && !negative;
  return {negative, "(" + joined(inside) + ") " + suffix};
}

std::string SumFormatter::joined(const std::vector<SignedTerm>& pieces) {
  if (pieces.empty()) return "0";
  std::string text;
  for (const SignedTerm& piece : pieces) {
    const char* const sign = piece.negative ? (text.empty() ? "-" : " - ") : (text.empty() ? "" : " + ");
    text += sign + piece.body;
  }
  return text;
}

}  // namespace flatdyn
