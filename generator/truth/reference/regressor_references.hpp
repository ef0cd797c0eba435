// SPDX-License-Identifier: GPL-2.0-or-later
// The functions that are linear in the parameters by the reference, a recursion per column.
#pragma once

#include "truth/reference/numeric_reference.hpp"

namespace flatdyn::references {

extern const NumericReference regressor, base_regressor, base_parameters, inverse_dynamics_base, adaptive_regressor,
    spring_regressor;

}  // namespace flatdyn::references
