// SPDX-License-Identifier: GPL-2.0-or-later
// Sums as polynomials, on which factoring and the sharing of partial sums work.
#pragma once

#include <array>
#include <initializer_list>
#include <span>
#include <vector>

#include "graph/hash_index.hpp"
#include "graph/passes/draft.hpp"

namespace flatdyn {

// The number of a product. Its factors are sorted and repeated for powers; a product without factors is 1. Equal
// products have the same number, so comparison is fast.
using MonomialId = int;

class MonomialTable {
 public:
  // Two products over their greatest common divisor.
  struct Split {
    MonomialId common, first, second;
  };

  MonomialId id(std::span<const NodeId> factors);
  MonomialId id(std::initializer_list<NodeId> factors) { return id(std::span(factors.begin(), factors.size())); }
  // The factors; valid until a product is added.
  std::span<const NodeId> operator[](MonomialId id) const {
    const auto k = static_cast<std::size_t>(id);
    return {factors_.data() + ends_[k], factors_.data() + ends_[k + 1]};
  }
  int degree(MonomialId id) const { return static_cast<int>((*this)[id].size()); }
  int size() const { return static_cast<int>(ends_.size()) - 1; }

  MonomialId product(MonomialId a, MonomialId b);
  Split split(MonomialId a, MonomialId b);
  MonomialId quotient(MonomialId a, MonomialId b);  // a / b, where b divides a
  bool divides(MonomialId divisor, MonomialId a) const;

 private:
  std::vector<NodeId> factors_;          // of all products, one after another
  std::vector<std::size_t> ends_ = {0};  // product k ends at ends_[k + 1]
  HashIndex index_;
  std::array<std::vector<NodeId>, 3> scratch_;
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
