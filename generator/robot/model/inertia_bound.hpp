// SPDX-License-Identifier: GPL-2.0-or-later
// A proven bound of how close to singular B(q) can come, at any position within the limits.
#pragma once

#include <string>
#include <vector>

#include "robot/model/mechanism.hpp"

namespace flatdyn {

// A number λ > 0 such that at every position within the limits of prismatic joints, for all rates q̇,
//     q̇ᵀ B(q) q̇ >= λ Σ_i b_i q̇_i²,  b_i >= b_ii(q) as from diagonal_bounds().
// Then B is positive definite, and every pivot of B = Lᵀ D L is at least λ times its scale
// (Factorisation::pivot_scales()). 0 if nothing is proven: links lack inertia, a joint before a prismatic one without
// limits of position, free symbols, closed loops, or a joint that has an entry of q but turns by another combination of
// entries.
//
// The proof compares energies. Link k has at least c_k ω_k² of them twice, c_k its smallest moment of inertia about its
// centre of mass, and m_k v_k²; the rate of a joint is at most the sum of what it connects: |q̇_k| <= ω_k + ω_parent for
// a revolute joint. On the other side b_kk is at most the moment of inertia, about the joint's axis, of all links that
// it moves, each as far from the axis as lengths allow. A floating base has m_0 v_C² and c_0 ω² of its own link, of
// which |v|² and ω² are asked for.
double scaled_inertia_bound(const Mechanism& mechanism);

// Where that holds, in words: "at every position", or less of a robot with prismatic joints.
std::string positions_of_inertia_bound(const Mechanism& mechanism);

// An upper bound of b_kk(q), kg m² or kg: the size of the terms whose sum it is.
struct DiagonalBound {
  double largest = 0;
  bool holds_everywhere = false;  // whatever q is; else only while prismatic joints keep their limits, see below
};

// The bounds by entry of q, from lengths: links are as far from a joint's axis as they can be. A prismatic joint
// without limits counts as if it stayed at 0. With closed loops they are those of the tree. Empty where bounds are
// unknown: free symbols.
std::vector<DiagonalBound> diagonal_bounds(const Mechanism& mechanism);

}  // namespace flatdyn
