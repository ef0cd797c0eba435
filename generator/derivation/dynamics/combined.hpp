// SPDX-License-Identifier: GPL-2.0-or-later
// Functions made from others, for use where these are computed anyway.
#pragma once

#include "graph/function.hpp"

namespace flatdyn {

// Replaces `torques`, inverse dynamics, by τ = B q̈ + n, (7.42), with the functions `inertia_matrix` for B and `bias`
// for n.
Function from_inertia_matrix(const Function& torques, const Function& inertia_matrix, const Function& bias);

// Replaces `energy` by ½ q̇ᵀ B q̇, (7.30).
Function from_inertia_matrix(const Function& energy, const Function& inertia_matrix);

}  // namespace flatdyn
