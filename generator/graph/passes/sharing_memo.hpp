// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "graph/function.hpp"

namespace flatdyn {

// Whether the functions have the same nodes and roots; names and texts may differ.
bool has_same_nodes(const Function& a, const Function& b);

// The results of sharing sums, by the functions that they were made from; the latest ones. Later rounds of the passes,
// and other choices of frames, come back to the same functions again and again.
class SharingMemo {
 public:
  // The result for a function with the same nodes, roots and names.
  std::optional<Function> find(const Function& function) const;

  void add(const Function& function, const Function& result);

 private:
  struct Entry {
    Function function;
    Graph result;
    std::vector<NodeId> image;  // by node of the function: the root of the result, if it is a root
    std::size_t size() const { return static_cast<std::size_t>(function.graph.size() + result.size()); }
  };

  std::deque<Entry> entries_;  // the oldest first
  std::size_t nodes_ = 0;
};

}  // namespace flatdyn
