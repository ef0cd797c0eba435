// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "graph/graph.hpp"

namespace flatdyn {

// Typical magnitudes of all nodes for an arm in motion (1 rad, 3 rad/s, 10 rad/s², 10 N m), with signs assumed
// independent: accurate enough to distinguish small terms of a sum from large ones.
std::vector<double> typical_magnitudes(const Graph& graph);

}  // namespace flatdyn
