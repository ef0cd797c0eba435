// SPDX-License-Identifier: GPL-2.0-or-later
// Derivatives of q̈(q, q̇, τ) from those of τ(q, q̇, q̈) at the solution. With weights w, the multipliers λ = B⁻¹ w, and
// indices k and l for derivatives along directions of all arguments but q̈,
//   (wᵀ q̈)_k  = -λᵀ τ_k,  and λ by τ
//   (wᵀ q̈)_kl = -(λᵀ τ_kl + (λᵀ B)_k q̈_l + (λᵀ B)_l q̈_k),
// which follow from τ(q, q̇, q̈(q, q̇, τ)) = τ, differentiated once and twice. (λᵀ B)_k is not zero for q alone.
#pragma once

#include "derivation/differentiation/differentiable.hpp"

namespace flatdyn {

// Forward dynamics, made ready for that. The robot must not have free symbols.
struct ImplicitAcceleration {
  // Outputs q̈ and λ and, for second derivatives, those of q̈ by q, q̇ and τ, square matrices; its last argument is w.
  const Function& solution;
  const Differentiable& torques;  // inverse dynamics, by all of its arguments
  const Tangents& tangents;
};

// wᵀ ∂q̈, with the outputs of vector_times_jacobian().
Function weighted_derivatives(const ImplicitAcceleration& acceleration);

// wᵀ ∂²q̈, with the outputs of contracted_hessian().
Function weighted_second_derivatives(const ImplicitAcceleration& acceleration);

}  // namespace flatdyn
