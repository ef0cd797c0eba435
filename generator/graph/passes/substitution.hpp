// SPDX-License-Identifier: GPL-2.0-or-later
// One graph inside another one, with nodes in the place of inputs.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "graph/function.hpp"

namespace flatdyn {

// The node that stands for an input; nullopt: the input stays.
using InputImage = std::function<std::optional<NodeId>(const Input& input, Graph& to)>;

// Adds all nodes of `from` to `to` in normal form, so that nodes that become 0 or equal are so at once. Returns the
// node in `to` of each.
std::vector<NodeId> substituted(const Graph& from, const InputImage& image_of, Graph& to);

// The same of a function's graph; returns its outputs in `to`.
std::vector<Output> substituted_outputs(const Function& from, const InputImage& image_of, Graph& to);

}  // namespace flatdyn
