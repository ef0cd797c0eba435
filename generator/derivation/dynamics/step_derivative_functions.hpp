// SPDX-License-Identifier: GPL-2.0-or-later
// The derivatives of steps in time (step_functions.hpp) as functions: A = ∂x'/∂x and B = ∂x'/∂τ with the state
// x = (q, q̇).
#pragma once

#include <optional>

#include "derivation/dynamics/derivation_context.hpp"

namespace flatdyn {

// Semi-implicit Euler, in the formulations of the derivatives of forward dynamics.
Function derive_semi_implicit_step_derivatives(const Mechanism& mechanism, const Choices& choices);
std::optional<Function> derive_semi_implicit_step_derivatives_by_products(const Mechanism& mechanism,
                                                                          const Choices& choices);

// The classical Runge-Kutta method of fourth order. The chain rule runs backwards through the stages: B⁻¹ multiplies
// the derivatives of the state after the step by q̈ of a stage, and only then the derivatives of torques, so that those
// of q̈ are not needed at the first two stages.
Function derive_runge_kutta_step_derivatives(const Mechanism& mechanism, const Choices& choices);

// The implicit midpoint rule (midpoint.hpp), with q̇' = qd_end after its iterations.
Function derive_midpoint_step_derivatives(const Mechanism& mechanism, const Choices& choices);

}  // namespace flatdyn
