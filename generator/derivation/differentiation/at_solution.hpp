// SPDX-License-Identifier: GPL-2.0-or-later
// Functions of given accelerations, at the accelerations that another function computes.
#pragma once

#include <vector>

#include "graph/function.hpp"

namespace flatdyn {

// Adds a function to a graph, with these nodes in the place of its accelerations and of its argument weights. Returns
// its outputs.
std::vector<Output> outputs_at(const Function& function, const std::vector<NodeId>& accelerations,
                               const std::vector<NodeId>& weights, Graph& graph);

}  // namespace flatdyn
