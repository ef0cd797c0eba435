// SPDX-License-Identifier: GPL-2.0-or-later
// The operands of a node without a list of them: orders of statements are tried thousands of times.
#pragma once

#include "graph/graph.hpp"

namespace flatdyn {

// Calls use(operand) in the order of operands_of.
template <class Use>
void for_each_operand(const Node& node, const Use& use) {
  for (const NodeId operand : node.operands) use(operand);
  for (const Term& term : node.terms) use(term.node);
}

}  // namespace flatdyn
