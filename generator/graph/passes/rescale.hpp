// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "graph/function.hpp"

namespace flatdyn {

// Computes a sum as a multiple of itself where all its users can absorb the factor into their coefficients: k·a + k·b,
// used as 3·S, becomes a + b, used as 3·k·S. Each sum gets the multiple that leaves the fewest multiplications.
Function rescale(const Function& function);

}  // namespace flatdyn
