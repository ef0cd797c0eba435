// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "truth/reference/reference_point.hpp"

namespace flatdyn {

// The absolute values of the entries of B⁻¹.
reference::MatrixX<double> absolute_inverse(const ReferencePoint<double>& at);

// The magnitude for q̈ = B⁻¹ (τ - n): the effect of an error as large as the terms of B q̈ + n - τ.
reference::VectorX<double> acceleration_magnitude(const ReferencePoint<double>& at);

}  // namespace flatdyn
