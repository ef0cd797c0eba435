// SPDX-License-Identifier: GPL-2.0-or-later
// Derivatives of inverse and forward dynamics as functions, from the mechanism's parameters as they are.
#pragma once

#include "symbolic/dynamics/workbench.hpp"

namespace flatdyn {

// The derivatives ∂τ/∂q, ∂τ/∂q̇.
Function torque_derivatives_function(Workbench& bench);

// The derivatives ∂q̈/∂q, ∂q̈/∂q̇, ∂q̈/∂τ = B⁻¹.
Function acceleration_derivatives_function(Workbench& bench);

}  // namespace flatdyn
