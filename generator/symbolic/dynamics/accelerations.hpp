// SPDX-License-Identifier: GPL-2.0-or-later
// q̈ from torques, (7.115), (7.116).
#pragma once

#include "symbolic/dynamics/factorisation.hpp"
#include "symbolic/dynamics/workbench.hpp"

namespace flatdyn {

// C q̇ + g + friction.
std::vector<Number> bias_torques(Workbench& bench);

// q̈ of B q̈ = τ - bias, B factorised; with bias_torques(), or the bias as given.
std::vector<Number> accelerations(Workbench& bench, const Factorisation& B);
std::vector<Number> accelerations(Workbench& bench, const Factorisation& B, const std::vector<Number>& bias);

}  // namespace flatdyn
