// SPDX-License-Identifier: GPL-2.0-or-later
// B(q) and the Christoffel symbols from composite bodies: joint k's body and all its descendants as one rigid body.
#pragma once

#include <array>
#include <map>

#include "derivation/dynamics/newton_euler.hpp"

namespace flatdyn {

// Composite bodies: body i and all its descendants, about the origin of frame i, in frame i.
std::vector<InertialParameters> composites(Frames& frames);

// The wrench that gives composite body i a unit acceleration of joint i, in frame i, without its rotor.
Wrench unit_wrench(Frames& frames, int i, const InertialParameters& composite);

// S_i ×* wrench: the derivative by q_i of a wrench that moves with joint i, in frame i.
Wrench derivative_by_joint(const Body& body, const Wrench& wrench);

// The inertia matrix B. Upper and lower entries are the same Number. Entries of joints on different branches are 0.
Rows inertia_matrix(Frames& frames);

// The mechanism with all inertias halved. christoffel_symbols() takes frames of it, so that the factor 1/2 of (7.45) is
// part of the constants.
Mechanism with_half_inertia(const Mechanism& mechanism);

// c_ijk of (7.45), with key (i, j, k), j <= k; a missing key means 0.
//
// b_ij does not depend on q_k for k <= min(i, j). For i < k <= j joint k and its descendants move as one body under
// joint i: ∂b_ij/∂q_k = S_iᵀ (S_k ×* F_j), where F_j is the unit wrench of composite body j. For i <= j < k only
// composite body k moves under both: ∂b_ij/∂q_k = S_iᵀ I'_k S_j. (After the composite-body forms of Echeandia and
// Wensing, 2021.)
std::map<std::array<int, 3>, Number> christoffel_symbols(Frames& frames);

}  // namespace flatdyn
