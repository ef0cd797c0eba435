// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "graph/function.hpp"

namespace flatdyn {

// The same function with its nodes in another order, which the seed decides: the same one on every machine. Greedy
// passes take what comes first of what saves alike, so they find another result. The seed 0 changes nothing.
Function reordered(Function function, unsigned seed);

}  // namespace flatdyn
