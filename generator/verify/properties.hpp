// SPDX-License-Identifier: GPL-2.0-or-later
// Properties of the equations of motion of any robot, checked on the generated functions' graphs in 50 digits.
#pragma once

#include "model/states.hpp"
#include "verify/verify.hpp"

namespace flatdyn {

// Checks that B is symmetric and positive definite, wᵀ(Ḃ - 2C)w = 0, (7.48), the energy balance, (7.50), and that
// forward ∘ inverse dynamics is the identity. A property whose functions are not all given is left out.
// `largest_angle_factor`: that of the mechanism; it coarsens differences by q by this factor. `scaled_inertia_bound`:
// that of the mechanism; if it is positive, it proves that B is positive definite at all positions.
std::vector<Property> check_properties(const std::vector<Function>& functions, const std::vector<State>& states,
                                       double largest_angle_factor = 1, double scaled_inertia_bound = 0);

}  // namespace flatdyn
