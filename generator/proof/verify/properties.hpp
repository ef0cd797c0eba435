// SPDX-License-Identifier: GPL-2.0-or-later
// Properties of the equations of motion of any robot, checked on the generated functions' graphs in 50 digits.
#pragma once

#include "proof/verify/verify.hpp"
#include "robot/model/states.hpp"

namespace flatdyn {

// The proof about pivots of B: they are at least this share of their scales (scaled_inertia_bound()), and where.
struct ProvenPivots {
  double share = 0;  // 0: nothing is proven
  std::string positions{};
};

// Checks that B is symmetric and positive definite, wᵀ(Ḃ - 2C)w = 0, (7.48), the energy balance, (7.50), and that
// forward ∘ inverse dynamics is the identity. A property whose functions are not all given is left out.
// `largest_angle_factor`: that of the mechanism; it coarsens differences by q by this factor.
// `mechanism`: needed for robots with spherical joints, whose orientations are made exactly unit quaternions, and for
// those with closed loops.
std::vector<Property> check_properties(const std::vector<Function>& functions, const std::vector<State>& states,
                                       double largest_angle_factor = 1, const ProvenPivots& proven = {},
                                       const Mechanism* mechanism = nullptr);

}  // namespace flatdyn
