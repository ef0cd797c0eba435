// SPDX-License-Identifier: GPL-2.0-or-later
// Functions of given accelerations, at the accelerations that another function computes.
#pragma once

#include <vector>

#include "graph/function.hpp"

namespace flatdyn {

// Adds a function to the graph of another one, with these nodes of it in the place of its accelerations and of its
// argument weights. Returns its outputs. The loops that it needs are required of the other one, too.
std::vector<Output> outputs_at(const Function& function, const std::vector<NodeId>& accelerations,
                               const std::vector<NodeId>& weights, Function& to);

}  // namespace flatdyn
