// SPDX-License-Identifier: GPL-2.0-or-later
// Square matrices of nodes of a graph.
#pragma once

#include <vector>

#include "graph/graph.hpp"

namespace flatdyn {

class SquareMatrices {
 public:
  using Entries = std::vector<NodeId>;  // row by row

  // The matrices have size × size entries; the graph must outlive this object.
  SquareMatrices(Graph& graph, int size) : graph_(graph), size_(size) {}

  Entries zero() const;
  Entries diagonal(NodeId x) const;  // x times the identity
  Entries scaled(NodeId factor, const Entries& a) const;
  Entries sum(const Entries& a, const Entries& b, int sign = 1) const;  // a + sign b
  Entries product(const Entries& a, const Entries& b) const;

  // X with A X = R by elimination without pivoting, for right-hand sides R of any number of columns.
  struct Solution {
    Entries x;
    std::vector<NodeId> pivots;
  };
  Solution solution(Entries A, Entries R, int columns) const;

  std::size_t at(int row, int column) const { return static_cast<std::size_t>(row * size_ + column); }
  int size() const { return size_; }

 private:
  Graph& graph_;
  int size_;
};

}  // namespace flatdyn
