// SPDX-License-Identifier: GPL-2.0-or-later
// The value of a function at a state, from its graph and from the reference; and the magnitude that its error is
// measured against.
#pragma once

#include "graph/function.hpp"
#include "verify/reference_model.hpp"
#include "verify/states.hpp"

namespace flatdyn {

// Entries of all outputs, in order.
template <class S>
std::vector<S> graph_values(const Function& function, const State& state);

// The same from the recursive Newton–Euler reference; nullopt for a function of a named link other than the tip, whose
// frame the reference is not set up for.
template <class S>
std::optional<std::vector<S>> reference_values(const Function& function, const reference::Robot<S>& robot,
                                               const State& state);

// The sum of the absolute values of each entry's own terms (flatdyn/reference/magnitude.hpp).
std::vector<double> magnitudes(const Function& function, const reference::Robot<double>& robot, const State& state);

}  // namespace flatdyn
