// SPDX-License-Identifier: GPL-2.0-or-later
// A polynomial with terms of named factors, in a readable order that does not depend on GiNaC's order by address.
#pragma once

#include <compare>
#include <map>
#include <string>
#include <vector>

#include "derivation/closed_form/closed_form.hpp"
#include "graph/rational.hpp"

namespace flatdyn {

// The kinds of factors, in the order in which they are written: k_r^2 I_m, m a g d_1 c_2 s_12.
enum class FactorKind { gear, dynamic, other, gravity, coordinate, quaternion, cosine, sine };

// A factor. gear … gravity, quaternion: `index` into FactorNames; coordinate: d of joint `index`; cosine, sine: of
// Σ angle[i] q_i over the joints, followed by multiples of Mechanism::angles.
struct Factor {
  FactorKind kind = FactorKind::other;
  int index = 0;
  std::vector<int> angle;

  bool operator==(const Factor&) const = default;
  std::strong_ordering operator<=>(const Factor& b) const;  // c_1, c_2, c_12
  bool is_trigonometric() const { return kind == FactorKind::cosine || kind == FactorKind::sine; }
};

using Monomial = std::map<Factor, int>;  // exponents are not zero
using ReadableSum = std::map<Monomial, Rational>;

// The names of the factors in a robot's sums, in the order in which people list them: by the number at the name's end
// (the link), then by the letters between underscore and number, then by those before: I_l1, m_l1, I_m1, I_l2. A factor
// is a free symbol, its sine or cosine, the reciprocal of an expression in free symbols, gravity in base axes, or an
// entry of a quaternion.
class FactorNames {
 public:
  FactorNames(const Mechanism& mechanism, const ClosedForm& form);

  // The expression as a sum. Throws Failure(unsupported) if it is not a polynomial in the known factors.
  ReadableSum readable(const Number& expression) const;
  const std::string& name(const Factor& factor) const { return entries_[static_cast<std::size_t>(factor.index)].name; }
  const Number& expression(const Factor& factor) const {
    return entries_[static_cast<std::size_t>(factor.index)].expression;
  }
  const std::vector<std::string>& all() const { return names_; }

 private:
  struct Entry {
    std::string name;
    FactorKind kind = FactorKind::other;
    Number expression;
  };

  void add_names_of_motion(const Mechanism& mechanism);
  void multiply(const Number& factor, int exponent, Monomial& monomial, Rational& coefficient) const;

  std::vector<Entry> entries_;
  std::vector<std::string> names_;
  const ClosedForm& form_;
};

// Rewrites a sum by c_1 c_2 - s_1 s_2 = c_12 for angles of parallel joints, and by 1 - c_1² = s_1², where that leaves
// fewer terms.
class AngleRewriter {
 public:
  explicit AngleRewriter(const Mechanism& mechanism);

  ReadableSum rewritten(ReadableSum sum) const;

 private:
  std::vector<std::vector<int>> groups_;  // angles of joints with parallel axes, each group in order
  int angles_;
};

}  // namespace flatdyn
