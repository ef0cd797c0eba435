// SPDX-License-Identifier: GPL-2.0-or-later
// Forward and reverse mode over the graph of a function. New nodes are added behind those of the function, whose ids
// stay.
#pragma once

#include <optional>
#include <vector>

#include "derivation/differentiation/tangents.hpp"

namespace flatdyn {

// The rates of all nodes of a function while its arguments move.
class ForwardMode {
 public:
  // `is_used`: by node of the function; `direction`: by number, none: zero.
  ForwardMode(const std::vector<bool>& is_used, const Tangents& tangents, std::vector<std::optional<NodeId>> direction,
              Graph& graph);

  NodeId rate(NodeId id);

 private:
  void find_rate(NodeId id);
  bool is_moving(NodeId id) const;

  const Tangents& tangents_;
  Graph& graph_;
  std::vector<std::optional<NodeId>> direction_, rates_;  // rates by node of the function; none: zero
};

// The derivatives of a weighted sum of nodes of a function.
class ReverseMode {
 public:
  // `weights`: by node of the function, terms that are added up.
  ReverseMode(const Tangents& tangents, Graph& graph, std::vector<std::vector<Term>> weights);

  // By direction.
  std::vector<NodeId> derivatives();

 private:
  void pass_on(NodeId id, NodeId weight, const Tangents& tangents);

  Graph& graph_;
  std::vector<std::vector<Term>> weights_;  // by node of the function
  std::vector<std::vector<Term>> result_;   // by direction
};

}  // namespace flatdyn
