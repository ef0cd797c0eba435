// SPDX-License-Identifier: GPL-2.0-or-later
// Derivatives of inverse and forward dynamics where closed loops are, along the motions of the independent joints, from
// the graph of inverse dynamics; where there are none, from the recursion
// (derivation/dynamics/derivative_functions.hpp).
#pragma once

#include "derivation/kernel/choices.hpp"
#include "graph/function.hpp"

namespace flatdyn {

// ∂τ/∂q, ∂τ/∂q̇.
Function inverse_dynamics_derivatives(const Mechanism& mechanism, const Choices& choices);

// ∂q̈/∂q, ∂q̈/∂q̇, ∂q̈/∂τ = B⁻¹.
Function forward_dynamics_derivatives(const Mechanism& mechanism, const Choices& choices);

// q̈, λ = B⁻¹ w with the argument weights w, and the same derivatives of q̈.
Function multipliers_and_derivatives(const Mechanism& mechanism, const Choices& choices);

}  // namespace flatdyn
