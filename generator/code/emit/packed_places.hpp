// SPDX-License-Identifier: GPL-2.0-or-later
// Packed outputs: entries that are always zero are left out, and equal ones, such as the halves of a symmetric matrix,
// are there once.
#pragma once

#include <vector>

#include "graph/function.hpp"

namespace flatdyn {

// By entry: its place among those that are left, in order; -1 if it is zero or is not written.
std::vector<int> packed_places(const Output& output, const Graph& graph);

// Whether every entry keeps its place.
bool is_identity(const std::vector<int>& places);

}  // namespace flatdyn
