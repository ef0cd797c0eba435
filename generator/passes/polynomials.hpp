// SPDX-License-Identifier: GPL-2.0-or-later
// Sums seen as polynomials: what factoring and sharing of partial sums work on.
#pragma once

#include <map>
#include <vector>

#include "passes/draft.hpp"

namespace flatdyn {

// Factors of a product, sorted, repeated for powers; empty: the number 1. Each has one number, so they compare fast.
using MonomialId = int;

class MonomialTable {
 public:
  MonomialId id(std::vector<NodeId> factors);
  const std::vector<NodeId>& operator[](MonomialId id) const { return factors_[static_cast<std::size_t>(id)]; }
  int degree(MonomialId id) const { return static_cast<int>((*this)[id].size()); }
  int size() const { return static_cast<int>(factors_.size()); }

  MonomialId product(MonomialId a, MonomialId b);
  MonomialId common(MonomialId a, MonomialId b);    // the largest that divides both
  MonomialId quotient(MonomialId a, MonomialId b);  // a / b; b divides a
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
  NodeId node;  // the sum that it stands for
  std::vector<PolynomialTerm> terms;
};

// Every sum of a function in full normal form as a polynomial; and back. A pass changes `polynomials` in between; a new
// polynomial is for a node that was added to the draft.
struct Polynomials {
  explicit Polynomials(const Function& flat);

  Draft draft;
  MonomialTable monomials;
  std::vector<Polynomial> polynomials;
  std::vector<int> uses;  // of each monomial: by terms, and by anything else that needs the product itself

  MonomialId monomial_of(NodeId node);
  int& uses_of(MonomialId id);
  Function finish();
};

}  // namespace flatdyn
