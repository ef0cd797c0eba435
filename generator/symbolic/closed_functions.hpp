// SPDX-License-Identifier: GPL-2.0-or-later
// Functions of small robots straight from the closed form (7.32), (7.39), (7.45), in sines of sums of parallel joints'
// angles: often shorter than the recursion. Which of the two is emitted, their cost decides.
#pragma once

#include <optional>

#include "graph/function.hpp"
#include "model/mechanism.hpp"

namespace flatdyn {

// The same function as `recursive`, with the same name and outputs. nullopt if the closed form does not have it, or is
// too long to be worth a try: more than three joints, or more terms than a person would read.
std::optional<Function> closed_variant(const Mechanism& mechanism, const Function& recursive);

}  // namespace flatdyn
