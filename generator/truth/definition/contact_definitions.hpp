// SPDX-License-Identifier: GPL-2.0-or-later
// The dynamics of a robot at the scene's contacts, by inverting the matrices of their equations.
#pragma once

#include "truth/definition/definition.hpp"

namespace flatdyn::definitions {

extern const Definition contact_jacobian, contact_bias, constrained_forward_dynamics, contact_inverse_dynamics,
    contact_impact, friction_cones;

}  // namespace flatdyn::definitions
