// SPDX-License-Identifier: GPL-2.0-or-later
// Sums as polynomials, on which factoring and the sharing of partial sums work.
#pragma once

#include <map>
#include <vector>

#include "passes/draft.hpp"

namespace flatdyn {

// The number of a product. Its factors are sorted and repeated for powers; a product without factors is 1. Equal
// products have the same number, so comparison is fast.
using MonomialId = int;

class MonomialTable {
 public:
  MonomialId id(std::vector<NodeId> factors);
  const std::vector<NodeId>& operator[](MonomialId id) const { return factors_[static_cast<std::size_t>(id)]; }
  int degree(MonomialId id) const { return static_cast<int>((*this)[id].size()); }
  int size() const { return static_cast<int>(factors_.size()); }

  MonomialId product(MonomialId a, MonomialId b);
  MonomialId common(MonomialId a, MonomialId b);    // the greatest common divisor
  MonomialId quotient(MonomialId a, MonomialId b);  // a / b, where b divides a
  bool divides(MonomialId divisor, MonomialId a) const;

 private:
  std::vector<std::vector<NodeId>> factors_;
  std::map<std::vector<NodeId>, MonomialId> ids_;
};

struct PolynomialTerm {
  Rational coefficient;
  MonomialId monomial;
};

struct Polynomial {
  NodeId node;  // the sum that this polynomial represents
  std::vector<PolynomialTerm> terms;
};

// Every sum of a function in full normal form as a polynomial, and the way back. A pass changes `polynomials` in
// between; a new polynomial belongs to a node that was added to the draft.
struct Polynomials {
  explicit Polynomials(const Function& flat);

  Draft draft;
  MonomialTable monomials;
  std::vector<Polynomial> polynomials;
  std::vector<int> uses;  // by monomial: its uses by terms and by other nodes that need the product itself

  MonomialId monomial_of(NodeId node);
  int& uses_of(MonomialId id);
  Function finish();
};

}  // namespace flatdyn
