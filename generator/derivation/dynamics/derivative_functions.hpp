// SPDX-License-Identifier: GPL-2.0-or-later
// Derivatives of inverse and forward dynamics as functions, from the mechanism's parameters as they are.
#pragma once

#include <optional>

#include "derivation/dynamics/derivation_context.hpp"

namespace flatdyn {

// All of these that return derivatives are for robots without closed loops (derivation/differentiation/along_loops.hpp
// has the others').

// The derivatives ∂τ/∂q, ∂τ/∂q̇.
Function derive_inverse_dynamics_derivatives(const Mechanism& mechanism, const Choices& choices);

// The derivatives ∂q̈/∂q, ∂q̈/∂q̇, ∂q̈/∂τ = B⁻¹.
Function derive_forward_dynamics_derivatives(const Mechanism& mechanism, const Choices& choices);

// The same, with q̈ and the columns as products with B⁻¹. nullopt for robots with closed loops.
std::optional<Function> derive_forward_dynamics_derivatives_by_products(const Mechanism& mechanism,
                                                                        const Choices& choices);

// ∂q̈/∂q, ∂q̈/∂q̇ where B⁻¹ is known, by entry of it (n × n, row by row): the entry k that has its value, read as the
// input of kind `stored` of index k; -1 if it is zero.
Function derive_acceleration_derivatives_from_inverse(const Mechanism& mechanism, const Choices& choices,
                                                      const std::vector<int>& inverse);

// q̈ = B⁻¹ (τ - n), the derivatives ∂τ/∂q and ∂τ/∂q̇ of inverse dynamics at this q̈, and B⁻¹. With a floating base these
// hold v̇ + ω × v - g_b fixed in the place of v̇, and two more matrices are what its turning axes add to -B⁻¹ ∂τ/∂q and
// to -B⁻¹ ∂τ/∂q̇ for the derivatives of q̈; they are zero with a fixed base.
Function derive_torque_derivatives_at_solution(const Mechanism& mechanism, const Choices& choices);

// Derivatives of a weighted sum wᵀ q̈ are made from q̈ and the multipliers λ = B⁻¹ w, where w is the argument weights;
// second derivatives from the same with the derivatives of q̈ by q, q̇ and τ, by substitution into B = Lᵀ D L or by
// products with B⁻¹.
Function derive_acceleration_and_multipliers(const Mechanism& mechanism, const Choices& choices);
Function derive_multipliers_and_derivatives(const Mechanism& mechanism, const Choices& choices);
Function derive_multipliers_and_derivatives_by_products(const Mechanism& mechanism, const Choices& choices);

// q̈, λ = B⁻¹ w and B⁻¹.
Function derive_multipliers_and_inverse(const Mechanism& mechanism, const Choices& choices);

}  // namespace flatdyn
