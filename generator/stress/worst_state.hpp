// SPDX-License-Identifier: GPL-2.0-or-later
// The state at which an error is largest, searched: rounding errors have no slope to follow.
#pragma once

#include <functional>
#include <vector>

#include "model/states.hpp"

namespace flatdyn {

struct SearchedState {
  State state;
  double error = 0;
};

// Evolution from the worst of `pool`, for so many evaluations of `error`: every child takes some of its coordinates
// from another state of the pool, or moves them a part of the way there, down to the last places. So it stays within
// the limits that the pool keeps. The same seed finds the same. `pool` has at least one state.
SearchedState worst_state(const std::function<double(const State&)>& error, const std::vector<State>& pool,
                          int evaluations, unsigned seed);

}  // namespace flatdyn
