// SPDX-License-Identifier: GPL-2.0-or-later
// The regressor of (7.80), (7.81): τ = Y(q, q̇, q̈) π, with π as in derivation/parameters/parameters.hpp. Column k of Y
// is the torque of the mechanism whose parameters are all zero but for π_k = 1. Entry (i, k) is zero unless joint i
// moves the joint that π_k belongs to: Y is block upper triangular for a chain, and sparse by branch for a tree. A
// rotor's column also has entries in the rows of the joints before its carrier, (7.30), which are all before its own.
//
// A tip payload that is held fast is part of the last link: its ten parameters, in that link's canonical frame, are
// added to the link's.
#pragma once

#include <vector>

#include "derivation/dynamics/body_motion.hpp"
#include "derivation/parameters/parameters.hpp"

namespace flatdyn {

// The columns of Y that are asked for, by their index in π: result[i][c] is entry (i, columns[c]). With two rates in
// `motion`, it is the regressor of B q̈_r + C(q, q̇) q̇_r + g + F_v q̇_r + F_s sgn(q̇_r).
Rows regressor(Frames& frames, const JointMotion& motion, const std::vector<int>& columns);

}  // namespace flatdyn
