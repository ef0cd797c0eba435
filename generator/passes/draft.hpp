// SPDX-License-Identifier: GPL-2.0-or-later
// What the passes work on: a Function whose nodes may be changed in place and added to.
#pragma once

#include <vector>

#include "graph/function.hpp"

namespace flatdyn {

struct Draft {
  explicit Draft(const Function& function);  // which must outlive the draft

  const Function& source;
  std::vector<Node> nodes;  // the source's, then the added ones; no cycles, but not in topological order

  NodeId add(Node node);
  NodeId add_sum(std::vector<Term> terms, const Rational& constant);
  NodeId add_product(std::vector<NodeId> factors);
  Node& at(NodeId id) { return nodes[static_cast<std::size_t>(id)]; }
  const Node& at(NodeId id) const { return nodes[static_cast<std::size_t>(id)]; }

  // How often each node is used: as a term, as an operand (repeated ones count), as a root.
  std::vector<int> use_counts() const;

  // The function again: what its roots reach, made by the constructors in the order of ids as far as operands allow.
  Function finish() const;
};

// Only what the roots reach.
Function without_dead_code(const Function& function);

// `node`, of any graph, in full normal form here, its operands being `image[operand]`.
NodeId unfolded_node(Graph& graph, const Node& node, const std::vector<NodeId>& image);

// In full normal form: scaled nodes and products that passes had kept as operands are folded in again.
Function unfolded(const Function& function);

// What a pass weighs: all operations, sin, cos and divisions as much as the additions that they take the time of.
int cost(const Function& function);

// Whether passes that have brought the cost down by so much should be run again: time is bounded, too.
bool is_worth_repeating(int cost_before, int cost_after);

// `candidate` if it costs less than `original` and has no more sin, cos or divisions; else `original`.
Function cheaper(const Function& original, const Function& candidate);

}  // namespace flatdyn
