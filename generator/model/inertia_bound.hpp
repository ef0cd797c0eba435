// SPDX-License-Identifier: GPL-2.0-or-later
// A proven bound of how close to singular B(q) can come, at any position within the limits.
#pragma once

#include "model/mechanism.hpp"

namespace flatdyn {

// A number λ > 0 such that at every position, for all rates q̇,
//     q̇ᵀ B(q) q̇ >= λ Σ_i b_ii(q) q̇_i².
// Then B is positive definite, and every pivot of B = Lᵀ D L is at least λ times its scale
// (Factorisation::pivot_scales()). 0 if nothing is proven: links lack inertia, a joint before a prismatic one without
// limits of position, free symbols, closed loops, or a joint that has an entry of q but turns by another combination of
// entries.
//
// The proof compares energies. Link k has at least c_k ω_k² of them twice, c_k its smallest moment of inertia about its
// centre of mass, and m_k v_k²; the rate of a joint is at most the sum of what it connects: |q̇_k| <= ω_k + ω_parent for
// a revolute joint. On the other side b_kk is at most the moment of inertia, about the joint's axis, of all links that
// it moves, each as far from the axis as lengths allow.
double scaled_inertia_bound(const Mechanism& mechanism);

}  // namespace flatdyn
