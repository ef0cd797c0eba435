// SPDX-License-Identifier: GPL-2.0-or-later
// Sums of named factors as text or LaTeX, grouped as people write them: m_l2 (a_1^2 + l_2^2 + 2 a_1 l_2 c_2).
#pragma once

#include <string>
#include <vector>

#include "derivation/notation/readable_sum.hpp"

namespace flatdyn {

enum class Notation { text, latex };

// The factors by which terms are grouped: masses and inertias, as in B, or gravity and joint positions, as in g.
enum class GroupBy { parameters, motion };

// A summand with its sign kept apart.
struct SignedTerm {
  bool negative = false;
  std::string body;
};

// Instead of a number of digits: every number is written in full, as a decimal that ends within 60 places or as a short
// fraction. Others are rounded to kRoundedDigits, and end in "...".
inline constexpr int kExactDigits = 0;

class SumFormatter {
 public:
  SumFormatter(const FactorNames& names, int joints, Notation notation, int digits,
               std::vector<CoordinateMultiple> further_angles = {});

  // From now on, sums of parameters begin with a positive term if they have one: "I_z - I_y".
  void begin_with_positive_terms() { positive_first_ = true; }

  std::vector<SignedTerm> pieces(const ReadableSum& sum, GroupBy group_by);
  std::string text(const ReadableSum& sum, GroupBy group_by) { return joined(pieces(sum, group_by)); }

  // The sum times the factor `suffix`, as one summand, in parentheses if necessary.
  static SignedTerm times(const std::vector<SignedTerm>& pieces, const std::string& suffix);
  static std::string joined(const std::vector<SignedTerm>& pieces);

  std::string subscript(const std::vector<int>& joints) const { return subscript(joints, joints_); }
  // The subscript of indices below `count`: "_12", "_1_12", "_{12}", "_{1,12}".
  std::string subscript(const std::vector<int>& indices, int count) const;
  std::string coordinate(const std::string& letter, int joint) const;  // "qd_1", "\dot{q}_{1}"

  // A positive number; a small fraction as such before symbols.
  std::string number(const Rational& magnitude, bool with_symbols);

  Notation notation() const { return notation_; }
  bool rounded() const { return rounded_; }        // whether a number was not printed in full
  bool long_names() const { return long_names_; }  // whether cos(q_1) is written out, as the robot has a symbol c_1

 private:
  std::string fraction(const Rational& magnitude) const;
  std::string decimal(const std::string& text) const;
  std::string factor(const Factor& factor);
  std::vector<Rational> multiples_of_coordinates(const Factor& factor) const;
  std::string trigonometric(const Factor& factor);
  std::string product(const Rational& magnitude, const Monomial& monomial);
  std::string monomial(const Monomial& monomial);
  std::vector<SignedTerm> sorted_terms(const ReadableSum& sum);
  SignedTerm group(const Monomial& common, const ReadableSum& rest, GroupBy group_by);

  const FactorNames& names_;
  int joints_;
  Notation notation_;
  int digits_;
  std::vector<CoordinateMultiple> further_angles_;  // Mechanism::angles
  bool long_names_ = false;
  bool rounded_ = false;
  bool positive_first_ = false;
};

}  // namespace flatdyn
