// SPDX-License-Identifier: GPL-2.0-or-later
// B = Lᵀ D L with the sparsity of the tree: an entry between joints on different branches stays zero (Featherstone,
// "Efficient factorization of the joint-space inertia matrix for branched kinematic trees", 2005).
#pragma once

#include "symbolic/newton_euler.hpp"

namespace flatdyn {

class Factorisation {
 public:
  // B as from inertia_matrix. Throws Failure(unsupported) if a pivot is exactly zero.
  Factorisation(Frames& frames, std::vector<std::vector<Number>> B);

  // x of B x = b. `name`: of the entries of x, as emitted.
  std::vector<Number> solve(std::vector<Number> b, const std::string& name) const;

  // B⁻¹, symmetric: entries named name_ik.
  std::vector<std::vector<Number>> inverse(const std::string& name) const;

  // D: all positive if and only if B is positive definite.
  const std::vector<Number>& pivots() const { return pivots_; }

 private:
  int parent(std::size_t i) const { return frames_.mechanism().bodies[i].parent; }

  Frames& frames_;
  std::vector<std::vector<Number>> L_;  // below the diagonal
  std::vector<Number> pivots_, inverse_;
};

}  // namespace flatdyn
