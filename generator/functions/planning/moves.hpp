// SPDX-License-Identifier: GPL-2.0-or-later
// Small changes of choices, in the order in which a search tries them.
#pragma once

#include <functional>
#include <vector>

#include "derivation/kernel/choices.hpp"

namespace flatdyn {

// Changes the choices; returns whether they differ from before.
using Move = std::function<bool(Choices&)>;

// All changes of a single choice: the length unit, one joint's balance, the place of its frame, its grouping, or the
// leaf frames.
std::vector<Move> possible_moves(const Mechanism& mechanism, const Choices& choices);

}  // namespace flatdyn
