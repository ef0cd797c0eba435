// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "graph/function.hpp"

namespace flatdyn {

// A sum that is a term of one other sum only is merged into it, and one that several use wherever terms cancel, if
// that costs no more: what is alike is then collected, and share_sums sees all terms at once.
Function like_terms(const Function& function);

// Whether a sum that several use is merged where that saves something, or wherever it costs nothing: (a + b) - (a + c)
// is b - c then, which others may share.
enum class Merging { where_it_saves, where_it_costs_nothing };

// The same in full normal form (nothing shared by keeping), whatever it costs.
Function with_merged_sums(const Function& function, Merging merging = Merging::where_it_saves);

}  // namespace flatdyn
