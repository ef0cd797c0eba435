// SPDX-License-Identifier: GPL-2.0-or-later
// Small changes of choices, in the order in which a search tries them.
#pragma once

#include <functional>
#include <vector>

#include "symbolic/kernel/choices.hpp"

namespace flatdyn {

// Whether the choices are others than before.
using Move = std::function<bool(Choices&)>;

// All that change one choice of these: the length unit, one joint's balance, where its frame is, its grouping, or the
// leaf frames.
std::vector<Move> possible_moves(const Mechanism& mechanism, const Choices& choices);

}  // namespace flatdyn
