// SPDX-License-Identifier: GPL-2.0-or-later
// What a straight line of operations computes at a state, in double: each result rounded, as compiled code rounds it
// without contraction.
#pragma once

#include <vector>

#include "model/states.hpp"
#include "verify/straight_line.hpp"

namespace flatdyn {

// By operation.
std::vector<double> values_of(const StraightLine& lines, const State& state);

// Entries of all outputs, in order; not-a-number where one is not written, or a condition does not hold.
std::vector<double> outputs_of(const StraightLine& lines, const State& state);

}  // namespace flatdyn
