// SPDX-License-Identifier: GPL-2.0-or-later
// Functions made of others, for where these are computed anyway.
#pragma once

#include "graph/function.hpp"

namespace flatdyn {

// τ = B q̈ + n, (7.42), in the place of `torques`, which is inverse dynamics; n: the function "bias", B:
// "inertia_matrix".
Function from_inertia_matrix(const Function& torques, const Function& inertia_matrix, const Function& bias);

// ½ q̇ᵀ B q̇, (7.30), in the place of `energy`.
Function from_inertia_matrix(const Function& energy, const Function& inertia_matrix);

}  // namespace flatdyn
