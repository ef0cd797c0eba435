// SPDX-License-Identifier: GPL-2.0-or-later
// The factorisation B = Lᵀ D L with the sparsity of the tree: an entry between joints on different branches stays zero
// (Featherstone, "Efficient factorization of the joint-space inertia matrix for branched kinematic trees", 2005).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/diagnostics/diagnostics.hpp"
#include "derivation/dynamics/newton_euler.hpp"

namespace flatdyn {

// Thrown if B(q) is singular at every q, because the pivot of a joint is exactly zero.
class SingularInertia : public Failure {
 public:
  explicit SingularInertia(const Body& body);
  std::string joint;  // the joint's name
};

class Factorisation {
 public:
  // Factorises B as from inertia_matrix(). Throws SingularInertia if a pivot is exactly zero.
  Factorisation(Frames& frames, Rows B);
  // Factorises any symmetric matrix. parents[k] < k, with -1 for roots: entries of row k are zero except on the path
  // from k to its root. `what`: the matrix, for messages; `prefix`: distinguishes its names from those of B.
  Factorisation(Derivation& derivation, std::vector<int> parents, Rows matrix, const std::string& what,
                const std::string& prefix);

  // solve() in two halves: y of Lᵀ y = b, then x of L x = D⁻¹ y. a · B⁻¹ b is Σ y_a y_b / D with only the first half of
  // each done.
  std::vector<Number> solved_transposed(std::vector<Number> b, const std::string& name) const;
  std::vector<Number> finished(const std::vector<Number>& y, const std::string& name) const;

  // The solution x of B x = b. `name`: prefix of its entries' names in emitted code.
  std::vector<Number> solve(std::vector<Number> b, const std::string& name) const;

  // B⁻¹, symmetric, with entries named name_ik.
  Rows inverse(const std::string& name) const;

  // The diagonal of D: all positive if and only if B is positive definite.
  const std::vector<Number>& pivots() const { return pivots_; }
  const std::vector<Number>& inverse_pivots() const { return inverse_; }
  // The diagonal of B.
  const std::vector<Number>& diagonal() const { return diagonal_; }
  // The scales of the pivots, a last place of which is their rounding error: pivot i is b_ii less terms l_ki² d_k, and
  // its scale is the size of b_ii plus l_ki² times the scale of d_k, since each term brings in the error of its own
  // pivot. sizes[i]: the size of the terms whose sum b_ii is, at least b_ii.
  std::vector<Number> pivot_scales(const std::vector<Number>& sizes) const;

 private:
  int parent(std::size_t i) const { return parents_[i]; }
  std::string name_of(std::size_t k) const { return label(static_cast<int>(k), base_bodies_); }
  void factorise(const std::function<void(std::size_t)>& fail_as_zero);

  Derivation& derivation_;
  int base_bodies_ = 0;
  std::vector<int> parents_;
  std::string prefix_;
  Rows L_;           // below the diagonal
  Rows eliminated_;  // row k: the terms l_ki² d_k that pivot k takes from the diagonal
  std::vector<Number> diagonal_, pivots_, inverse_;
};

}  // namespace flatdyn
