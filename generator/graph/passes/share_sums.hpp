// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "graph/function.hpp"

namespace flatdyn {

// Makes partial sums that several sums have in common, up to a common factor, nodes of their own; within one sum, a·x +
// b·x becomes (a + b)·x. The pass is greedy by savings and takes two terms at a time: c·x·(a + r·b) may occur in many
// sums with different c and x, and longer partial sums grow from it.
Function share_sums(const Function& function);

// The same pass, whatever it costs; for passes that have rewritten sums so that more may be shared.
Function with_shared_sums(const Function& function);

}  // namespace flatdyn
