// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "graph/function.hpp"

namespace flatdyn {

// Partial sums that several sums have in common, up to a common factor, become nodes of their own; and within one sum
// a·x + b·x becomes (a + b)·x. Greedy by savings, two terms at a time: c·x·(a + r·b) may stand in many sums with
// different c and x, and longer ones grow from it.
Function share_sums(const Function& function);

// The same, whatever it costs: for passes that have rewritten sums so that more may be shared.
Function with_shared_sums(const Function& function);

}  // namespace flatdyn
