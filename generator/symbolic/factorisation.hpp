// SPDX-License-Identifier: GPL-2.0-or-later
// B = Lᵀ D L with the sparsity of the tree: an entry between joints on different branches stays zero (Featherstone,
// "Efficient factorization of the joint-space inertia matrix for branched kinematic trees", 2005).
#pragma once

#include "symbolic/newton_euler.hpp"

namespace flatdyn {

struct Solution {
  std::vector<Number> x;       // B x = b
  std::vector<Number> pivots;  // D: all positive if and only if B is positive definite
};

// B as from inertia_matrix; overwritten by its factors.
// Throws Failure(unsupported) if a pivot is exactly zero.
Solution solve_factorised(Frames& frames, std::vector<std::vector<Number>> B, std::vector<Number> b);

}  // namespace flatdyn
