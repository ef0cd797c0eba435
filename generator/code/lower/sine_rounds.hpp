// SPDX-License-Identifier: GPL-2.0-or-later
// Sines and cosines of angles that a function computes. Those that can be evaluated together are a round, which has
// arrays of its own.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "code/lower/expressions.hpp"
#include "code/lower/schedule.hpp"
#include "code/statement.hpp"
#include "graph/graph.hpp"

namespace flatdyn {

class SineRounds {
 public:
  // Both arguments must outlive this object.
  SineRounds(const Graph& graph, const Schedule& schedule);

  std::size_t count() const { return rounds_.size(); }
  // The sines and cosines of a round, in the order of their statements.
  const std::vector<NodeId>& sines(std::size_t round) const { return rounds_[round].sines; }
  std::size_t round_of(NodeId sine) const { return place_of(sine).first; }

  // The entry of a round's array that has the sine or cosine: sine_1[2].
  code::Element entry(NodeId sine) const;
  // The arrays of a round: angle_1, sine_1, cosine_1; and the names of all.
  code::Declare arrays(std::size_t round) const;
  std::vector<std::string> names() const;
  // The statements that fill them.
  code::Statements filling(std::size_t round, const NodeExpressions& expressions) const;

 private:
  struct Round {
    std::vector<NodeId> sines, angles;
  };
  using Place = std::pair<std::size_t, int>;  // a round and an index

  const Place& place_of(NodeId sine) const { return places_.at(graph_[sine].operands[0]); }

  const Graph& graph_;
  std::vector<Round> rounds_;
  std::map<NodeId, Place> places_;  // by angle
};

}  // namespace flatdyn
