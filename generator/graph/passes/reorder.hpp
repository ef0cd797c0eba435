// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "graph/function.hpp"

namespace flatdyn {

// The same function with its nodes in another order, which the seed decides, equally on every machine. Greedy passes
// take the first of several equal savings, so another order leads them to another result. The seed 0 changes nothing.
Function reordered(Function function, unsigned seed);

}  // namespace flatdyn
