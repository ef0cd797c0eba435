// SPDX-License-Identifier: GPL-2.0-or-later
// Functions of small robots derived directly from the closed form (7.32), (7.39), (7.45), with sines of sums of
// parallel joints' angles. They are often shorter than the recursion; the cheaper of the two is emitted.
#pragma once

#include <optional>

#include "graph/function.hpp"
#include "model/mechanism.hpp"

namespace flatdyn {

// The same function as `recursive`, with the same name and outputs. nullopt if the closed form does not have it, or is
// too long to be tried: more than three joints, or more terms than a person would read.
std::optional<Function> closed_variant(const Mechanism& mechanism, const Function& recursive);

}  // namespace flatdyn
