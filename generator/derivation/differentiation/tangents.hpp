// SPDX-License-Identifier: GPL-2.0-or-later
// The directions along which the arguments of a function vary: one number for each entry of an argument. Positions vary
// in the tangent space, so that there is one for each entry of q̇: three for a spherical joint, whose child turns about
// its own axes, R ← R exp(S(δ)), and six for a floating base, whose displacement changes nothing and whose turn turns
// g_b, while the numbers in velocities and accelerations are held. With closed loops, the dependent joints move along
// with the independent ones.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "graph/function.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

// The directions of one argument: `length` of them, from number `first` on.
struct TangentBlock {
  InputKind kind;
  int first = 0, length = 0;
};

class Tangents {
 public:
  // The directions of a function with these arguments but weights, and of the robot's free symbols after them.
  Tangents(const Mechanism& mechanism, const std::vector<InputKind>& arguments, int base_parameters);

  // With closed loops, the directions of q are those of the independent joints, and the others move along, at the rates
  // G (derivation/loops/loops.hpp): its entries, row by row, as nodes of the graphs that rates_of() is given.
  void move_along(std::vector<NodeId> G) { motion_ = std::move(G); }

  const std::vector<TangentBlock>& blocks() const { return blocks_; }
  int count() const { return count_; }
  // The directions of an argument; null if the function does not have it.
  const TangentBlock* find(InputKind argument) const;
  // Whether second derivatives by two arguments do not depend on the order. Those by turns do: of q by itself, and of q
  // and g_b, which turns with the base; with closed loops those of q and of free symbols, as lengths change G.
  bool commute(InputKind a, InputKind b) const;

  // "qd[k]"; of q, where it has other entries than there are directions, "q, or a turn, along entry k of v".
  std::string words_for_entry(const TangentBlock& block, const std::string& index) const;
  // "q (7), qd (7), then the parameters (2)", the blocks in their order.
  std::string words_for_all() const;

  // The rate of an input is Σ factor_k d_k over directions d.
  struct Rate {
    NodeId factor;
    int direction;
  };
  std::vector<Rate> rates_of(Input input, Graph& graph) const;  // the input may be one of the graph's

 private:
  void add(InputKind kind, int length);
  void add_rates_of_position(int entry, int first, Graph& graph, std::vector<Rate>& rates) const;
  void add_rates_along_loops(int entry, int first, const Graph& graph, std::vector<Rate>& rates) const;

  const Mechanism& mechanism_;
  std::vector<TangentBlock> blocks_;
  int count_ = 0;
  std::vector<NodeId> motion_;  // G
};

// "qd", or "parameters".
std::string name_of(const TangentBlock& block);
// "H_q_qd", the name of second derivatives.
std::string name_of_second_derivatives(const TangentBlock& a, const TangentBlock& b);
// "qd", or "the parameters".
std::string words_for(const TangentBlock& block);

}  // namespace flatdyn
