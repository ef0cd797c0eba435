// SPDX-License-Identifier: GPL-2.0-or-later
// The functions that are linear in the parameters, by their definitions. A base regressor is right if Y_b K is Y: its
// columns, which are among those of Y, and K are then right, too.
#pragma once

#include "truth/definition/definition.hpp"

namespace flatdyn::definitions {

extern const Definition regressor, base_regressor, base_parameters, inverse_dynamics_base, adaptive_regressor,
    spring_regressor;

}  // namespace flatdyn::definitions
