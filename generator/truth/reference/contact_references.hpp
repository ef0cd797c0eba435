// SPDX-License-Identifier: GPL-2.0-or-later
// Dynamics at contacts by the reference.
#pragma once

#include "truth/reference/numeric_reference.hpp"

namespace flatdyn::references {

extern const NumericReference contact_jacobian, contact_bias, constrained_forward_dynamics, contact_inverse_dynamics,
    contact_impact, friction_cones;

}  // namespace flatdyn::references
