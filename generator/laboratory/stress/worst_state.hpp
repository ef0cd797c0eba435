// SPDX-License-Identifier: GPL-2.0-or-later
// Search for the state at which an error is largest; rounding errors have no gradient to follow.
#pragma once

#include <functional>
#include <vector>

#include "robot/model/states.hpp"

namespace flatdyn {

struct SearchedState {
  State state;
  double error = 0;
};

// Evolution from the worst of `pool` by `evaluations` calls of `error`: every child takes some of its coordinates from
// another state of the pool, or moves them part of the way there, down to the last places. So it stays within the
// limits of the pool. Deterministic for a given seed. `pool` has at least one state.
SearchedState worst_state(const std::function<double(const State&)>& error, const std::vector<State>& pool,
                          int evaluations, unsigned seed);

}  // namespace flatdyn
