// SPDX-License-Identifier: GPL-2.0-or-later
// The accelerations q̈ from torques, (7.115), (7.116).
#pragma once

#include "derivation/dynamics/derivation_context.hpp"
#include "derivation/dynamics/factorisation.hpp"

namespace flatdyn {

// The bias torques C q̇ + g + friction.
std::vector<Number> bias_torques(DerivationContext& context);

// The solution q̈ of B q̈ = τ - bias, with B factorised. The bias is bias_torques(), or as given.
std::vector<Number> accelerations(DerivationContext& context, const Factorisation& B);
std::vector<Number> accelerations(DerivationContext& context, const Factorisation& B, const std::vector<Number>& bias);

}  // namespace flatdyn
