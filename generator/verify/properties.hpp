// SPDX-License-Identifier: GPL-2.0-or-later
// What the equations of motion of any robot obey, checked on the generated functions' graphs in 50 digits.
#pragma once

#include "model/states.hpp"
#include "verify/verify.hpp"

namespace flatdyn {

// B symmetric and positive definite; wᵀ(Ḃ - 2C)w = 0, (7.48); energy balance, (7.50); forward ∘ inverse = identity.
// A property whose functions are not among those given is left out.
// `largest_turn`: of the mechanism; it makes differences by q as much coarser.
std::vector<Property> check_properties(const std::vector<Function>& functions, const std::vector<State>& states,
                                       double largest_turn = 1);

}  // namespace flatdyn
