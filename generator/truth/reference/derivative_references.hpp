// SPDX-License-Identifier: GPL-2.0-or-later
// Derivatives of inverse and forward dynamics by the reference.
#pragma once

#include "flatdyn/reference/derivatives.hpp"
#include "truth/reference/reference_point.hpp"

namespace flatdyn {

// The magnitudes for ∂q̈ = -B⁻¹ ∂(B q̈ + n): the effect of an error as large as the terms of B ∂q̈ + ∂(B q̈ + n),
// including that of q̈ itself.
reference::AccelerationDerivatives<double> acceleration_derivative_magnitudes(const ReferencePoint<double>& at);

namespace references {

extern const NumericReference inverse_dynamics_derivatives, forward_dynamics_derivatives;

}  // namespace references
}  // namespace flatdyn
