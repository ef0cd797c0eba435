// SPDX-License-Identifier: GPL-2.0-or-later
// B = Lᵀ D L with the sparsity of the tree: an entry between joints on different branches stays zero (Featherstone,
// "Efficient factorization of the joint-space inertia matrix for branched kinematic trees", 2005).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "diagnostics/diagnostics.hpp"
#include "symbolic/dynamics/newton_euler.hpp"

namespace flatdyn {

// B(q) is singular at every q, because the pivot of a joint is exactly zero.
class SingularInertia : public Failure {
 public:
  explicit SingularInertia(const Body& body);
  std::string joint;  // its name
};

class Factorisation {
 public:
  // B as from inertia_matrix. Throws SingularInertia if a pivot is exactly zero.
  Factorisation(Frames& frames, Rows B);
  // Of any symmetric matrix; parents[k] < k, below -1: those entries of row k are zero that are not on the way from k
  // to -1. `what` is the matrix, for messages; `prefix` sets its names apart from those of B.
  Factorisation(Derivation& derivation, std::vector<int> parents, Rows matrix, const std::string& what,
                const std::string& prefix);

  // solve() in two halves: y of Lᵀ y = b, then x of L x = D⁻¹ y. a · B⁻¹ b is Σ y_a y_b / D with both halves done.
  std::vector<Number> half_solved(std::vector<Number> b, const std::string& name) const;
  std::vector<Number> finished(const std::vector<Number>& y, const std::string& name) const;

  // x of B x = b. `name`: of the entries of x, as emitted.
  std::vector<Number> solve(std::vector<Number> b, const std::string& name) const;

  // B⁻¹, symmetric: entries named name_ik.
  Rows inverse(const std::string& name) const;

  // D: all positive if and only if B is positive definite.
  const std::vector<Number>& pivots() const { return pivots_; }
  const std::vector<Number>& inverse_pivots() const { return inverse_; }
  // The matrix's own, of which the pivots are what is left.
  const std::vector<Number>& diagonal() const { return diagonal_; }

 private:
  int parent(std::size_t i) const { return parents_[i]; }
  void factorise(const std::function<void(std::size_t)>& fail_as_zero);

  Derivation& derivation_;
  std::vector<int> parents_;
  std::string prefix_;
  Rows L_;  // below the diagonal
  std::vector<Number> diagonal_, pivots_, inverse_;
};

}  // namespace flatdyn
