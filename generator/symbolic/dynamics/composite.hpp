// SPDX-License-Identifier: GPL-2.0-or-later
// B(q) and the Christoffel symbols from composite bodies: all that moves with joint k, taken as one rigid body.
#pragma once

#include <array>
#include <map>

#include "symbolic/dynamics/newton_euler.hpp"

namespace flatdyn {

// Composite of body i and all behind it, about the origin of frame i, in frame i.
std::vector<InertialParameters> composites(Frames& frames);

// The wrench that gives composite body i a unit acceleration of joint i; in frame i. Without its rotor.
Wrench unit_wrench(Frames& frames, int i, const InertialParameters& composite);

// S_i ×* wrench: how a wrench that moves with joint i changes with q_i, in frame i.
Wrench swept_by(const Body& body, const Wrench& wrench);

// Upper and lower entries are the same Number. Entries of joints on different branches are 0.
Rows inertia_matrix(Frames& frames);

// The factor 1/2 of (7.45) is put into the constants: christoffel_symbols is given frames of the mechanism with all
// inertias halved.
Mechanism with_half_inertia(const Mechanism& mechanism);

// c_ijk of (7.45): key (i, j, k) with j <= k; what is missing is 0.
//
// b_ij does not depend on q_k for k <= min(i, j). For i < k <= j everything from joint k on moves as one under joint i:
// ∂b_ij/∂q_k = S_iᵀ (S_k ×* F_j), F_j the unit wrench of composite body j. For i <= j < k only composite body k moves
// under both: ∂b_ij/∂q_k = S_iᵀ I'_k S_j. (After the composite-body forms of Echeandia and Wensing, 2021.)
std::map<std::array<int, 3>, Number> christoffel_symbols(Frames& frames);

}  // namespace flatdyn
