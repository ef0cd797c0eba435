// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "graph/function.hpp"

namespace flatdyn {

// Merges a sum that is a term of only one other sum into that sum. A sum with several uses is merged wherever terms
// cancel, if that costs no more. Like terms are then collected, and share_sums sees all terms at once.
Function like_terms(const Function& function);

// Whether a sum with several uses is merged only where that saves something, or wherever it costs nothing: then (a + b)
// - (a + c) becomes b - c, which others may share.
enum class Merging { where_it_saves, where_it_costs_nothing };

// The same pass on the full normal form (no operand kept unfolded), whatever it costs.
Function with_merged_sums(const Function& function, Merging merging = Merging::where_it_saves);

}  // namespace flatdyn
