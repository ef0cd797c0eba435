// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/notation/combination_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <vector>

#include "base/diagnostics/table.hpp"
#include "derivation/notation/exact_text.hpp"
#include "robot/model/field_mechanism.hpp"

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

// The summands with their signs: "a", "- b", "+ c".
std::vector<std::string> signed_texts(const std::vector<Summand>& pieces) {
  std::vector<std::string> texts;
  for (const Summand& piece : pieces) {
    const std::string sign = piece.negative ? (texts.empty() ? "-" : "- ") : (texts.empty() ? "" : "+ ");
    texts.push_back(sign + piece.body);
  }
  if (texts.empty()) texts.emplace_back("0");
  return texts;
}

std::string joined_summands(const std::vector<Summand>& pieces) {
  return fmt::format("{}", fmt::join(signed_texts(pieces), " "));
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

std::vector<CombinationTerm> canonical_terms(const Mechanism& mechanism, const BaseParameters& base, std::size_t k) {
  std::vector<CombinationTerm> terms = {{parameter_name(base.columns[k], mechanism.base_bodies()), 1}};
  for (const auto& [index, coefficient] : base.combination[k]) {
    if (index != base.columns[k]) terms.push_back({parameter_name(index, mechanism.base_bodies()), coefficient});
  }
  return terms;
}

std::vector<Summand> summands_of(const std::vector<CombinationTerm>& terms, int digits) {
  std::vector<Summand> pieces;
  for (const auto& [name, coefficient] : terms) {
    const Summand factor = coefficient_piece(coefficient, digits);
    pieces.push_back({factor.negative, factor.body + (factor.body.empty() ? "" : " ") + name});
  }
  return pieces;
}

// The degree of a moment of mass: 0 for m, 1 for m r, 2 for moments of inertia; more for parameters of joints.
int degree_of(int index) {
  const Parameter kind = parameter_of(index);
  if (static_cast<int>(kind) >= kInertialPerBody) return static_cast<int>(kind);
  return kind == Parameter::m ? 0 : kind < Parameter::Ixx ? 1 : 2;
}

// The rest that is left where turns between frames, which have 80 digits, cancel.
bool is_dust(const Number& coefficient) {
  constexpr double kDust = 1e-30;
  return is_rational(coefficient) && std::abs(nearest_double(coefficient)) < kDust;
}

// The terms of a combination in the file's parameters, in their order, but that the first is of the body and the degree
// of the kept one in π.
std::vector<CombinationTerm> file_terms(const ParameterForm& form, const std::vector<FileParameter>& parameters,
                                        int kept) {
  std::vector<CombinationTerm> terms;
  std::optional<std::size_t> first;
  for (const auto& [f, coefficient] : in_file_parameters(form, parameters)) {
    if (is_dust(coefficient)) continue;
    const FileParameter& parameter = parameters[static_cast<std::size_t>(f)];
    const bool is_alike = joint_of(parameter.index) == joint_of(kept) && degree_of(parameter.index) == degree_of(kept);
    if (is_alike && !first) first = terms.size();
    terms.push_back({parameter.name, coefficient});
  }
  const auto begin = terms.begin(), found = begin + static_cast<std::ptrdiff_t>(first.value_or(0));
  if (first) std::rotate(begin, found, found + 1);
  return terms;
}

}  // namespace

std::string coefficient_text(const Number& coefficient) {
  const Summand piece = coefficient_piece(coefficient, kExact);
  return (piece.negative ? "-" : "") + (piece.body.empty() ? "1" : piece.body);
}

Combinations::Combinations(const Mechanism& mechanism, const BaseParameters& base, ParameterFrames frames,
                           ParameterSet set) {
  if (!has_names_of_file(mechanism, frames)) {
    for (std::size_t k = 0; k < base.columns.size(); ++k) terms_.push_back(canonical_terms(mechanism, base, k));
    return;
  }
  const std::vector<FileParameter> parameters = file_parameters(mechanism, set);
  for (std::size_t k = 0; k < base.columns.size(); ++k) {
    terms_.push_back(file_terms(base.combination[k], parameters, base.columns[k]));
  }
}

std::string Combinations::text(int k, int digits) const { return joined_summands(summands_of(terms(k), digits)); }

std::vector<std::string> Combinations::lines(int k, std::size_t width) const {
  std::vector<std::string> lines;
  for (const std::string& summand : signed_texts(summands_of(terms(k), kShortDigits))) {
    if (lines.empty() || text_width(lines.back()) + 1 + text_width(summand) > width) {
      lines.push_back(summand);
    } else {
      lines.back() += " " + summand;
    }
  }
  return lines;
}

std::string frames_text(const Mechanism& mechanism, ParameterFrames frames) {
  if (has_names_of_file(mechanism, frames)) {
    return "the link frames of the robot file: m(L) is the mass of link L, mlx(L) its first moment, Ixx(L) its moment "
           "of inertia about the origin of its frame, with the rotors that it carries; Im(J) is the rotor inertia, "
           "Fv(J) and Fs(J) are the friction of joint J";
  }
  return fmt::format(
      "{} (z along the joint's axis): link i is moved by the i-th joint {}, with the links that are fixed to it and "
      "the "
      "rotors that it carries; m2 is the mass of link 2, m2lx its first moment, I2xx its moment of inertia about the "
      "origin of its frame; Im2 is the rotor inertia, Fv2 and Fs2 are the friction of joint 2",
      has_canonical_links(mechanism) ? "the link frames of the robot file, which are the canonical ones"
                                     : "canonical frames",
      mechanism.is_coupled() ? "that moves, in depth-first order" : "of q");
}

}  // namespace flatdyn
