// SPDX-License-Identifier: GPL-2.0-or-later
// The invariants of every Graph and Function as a check, for tests and for debugging passes.
#pragma once

#include <optional>
#include <string>

#include "graph/function.hpp"

namespace flatdyn {

// The first invariant that does not hold, in words with the node's id; nothing if all hold:
//   operands exist before the node that uses them; no two nodes are the same; every node is in the form that
//   graph.hpp gives for its op; copying it changes nothing; roots exist; outputs have rows · cols entries;
//   an input that is read is of a kind the function declares.
std::optional<std::string> check_well_formed(const Function& function);

}  // namespace flatdyn
