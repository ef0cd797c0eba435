// SPDX-License-Identifier: GPL-2.0-or-later
// The last pass writes tanh by sums, products, quotients and signs, which all languages have.
#pragma once

#include "graph/function.hpp"

namespace flatdyn {

bool has_tanh(const Function& function);

// The function with the rational function of graph/rational_tanh.hpp in place of each tanh. It comes after all other
// passes, which would change how it rounds.
Function expand_tanh(const Function& function);

}  // namespace flatdyn
