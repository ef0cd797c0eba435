// SPDX-License-Identifier: GPL-2.0-or-later
// The working copy of a pass: a Function whose nodes may be changed in place and added to.
#pragma once

#include <vector>

#include "graph/function.hpp"

namespace flatdyn {

struct Draft {
  explicit Draft(const Function& function);  // the function must outlive the draft

  const Function& source;
  std::vector<Node> nodes;  // the function's nodes, then the added ones; without cycles, but not in topological order

  NodeId add(Node node);
  NodeId add_sum(std::vector<Term> terms, const Rational& constant);
  NodeId add_product(std::vector<NodeId> factors);
  Node& at(NodeId id) { return nodes[static_cast<std::size_t>(id)]; }
  const Node& at(NodeId id) const { return nodes[static_cast<std::size_t>(id)]; }

  // The number of uses of each node as a term, as an operand (repeated ones count) and as a root.
  std::vector<int> use_counts() const;

  // The finished function: the nodes that the roots reach, made by the constructors in the order of ids as far as
  // operands allow.
  Function finish() const;
};

// The function without nodes that no root reaches.
Function without_dead_code(const Function& function);

// Adds `node` of any graph to this one in full normal form, operand k becoming image[k].
NodeId unfolded_node(Graph& graph, const Node& node, const std::vector<NodeId>& image);

// The function in full normal form: scaled nodes and products that passes had kept as operands are folded in again.
Function unfolded(Function function);

// The cost that passes reduce: all operations, with sin, cos and divisions weighted by the additions that take as long.
int cost(const Function& function);

// Whether passes that have reduced the cost by this much are worth another run; this bounds the time, too.
bool is_worth_repeating(int cost_before, int cost_after);

// `candidate` if it costs less than `original` and has no more sin, cos and divisions; else `original`.
Function cheaper(Function original, Function candidate);

}  // namespace flatdyn
