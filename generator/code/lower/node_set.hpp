// SPDX-License-Identifier: GPL-2.0-or-later
// Sets of a graph's nodes, of which many are kept, joined and weighed.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "graph/graph.hpp"

namespace flatdyn {

class NodeSet {
 public:
  NodeSet() = default;
  explicit NodeSet(NodeId nodes) : words_((static_cast<std::size_t>(nodes) + kBits - 1) / kBits, 0) {}

  void add(NodeId id) { words_[static_cast<std::size_t>(id) / kBits] |= std::uint64_t(1) << bit(id); }
  bool has(NodeId id) const { return (words_[static_cast<std::size_t>(id) / kBits] >> bit(id) & 1) != 0; }
  // Adds all nodes of another set of the same graph.
  void add(const NodeSet& other) {
    for (std::size_t k = 0; k < words_.size(); ++k) words_[k] |= other.words_[k];
  }

  // The sum of weights, by node, of this set, and of its nodes that are in another set of the same graph, too.
  long weight(const std::vector<long>& weights) const {
    return weighed(weights, [this](std::size_t k) { return words_[k]; });
  }
  long weight_with(const NodeSet& other, const std::vector<long>& weights) const {
    return weighed(weights, [this, &other](std::size_t k) { return words_[k] & other.words_[k]; });
  }

 private:
  static constexpr std::size_t kBits = 64;
  static std::size_t bit(NodeId id) { return static_cast<std::size_t>(id) % kBits; }

  template <class Word>
  long weighed(const std::vector<long>& weights, const Word& word) const {
    long sum = 0;
    for (std::size_t k = 0; k < words_.size(); ++k) {
      for (std::uint64_t left = word(k); left != 0; left &= left - 1) {
        sum += weights[k * kBits + static_cast<std::size_t>(std::countr_zero(left))];
      }
    }
    return sum;
  }

  std::vector<std::uint64_t> words_;
};

}  // namespace flatdyn
