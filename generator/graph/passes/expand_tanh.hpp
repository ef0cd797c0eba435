// SPDX-License-Identifier: GPL-2.0-or-later
// What languages have instead of tanh: sums, products, quotients and signs.
#pragma once

#include "graph/function.hpp"

namespace flatdyn {

bool has_tanh(const Function& function);

// The function with the rational function of graph/rational_tanh.hpp in place of each tanh. It comes after all other
// passes, which would change how it rounds.
Function expand_tanh(const Function& function);

}  // namespace flatdyn
