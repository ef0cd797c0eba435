// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "graph/function.hpp"

namespace flatdyn {

// A sum may be computed as any multiple of itself, if all that use it can take the factor into coefficients of theirs:
// k·a + k·b, used as 3·S, becomes a + b, used as 3·k·S. Each sum gets the multiple that leaves the fewest
// multiplications.
Function rescale(const Function& function);

}  // namespace flatdyn
