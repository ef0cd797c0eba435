// SPDX-License-Identifier: GPL-2.0-or-later
#include "graph/passes/reorder.hpp"

#include <random>
#include <utility>
#include <vector>

namespace flatdyn {
namespace {

std::size_t place_of(NodeId id) { return static_cast<std::size_t>(id); }

// A random topological order: operands come before their users, and the random engine chooses among the nodes that may
// come next.
std::vector<NodeId> random_order(const Graph& graph, unsigned seed) {
  std::vector<std::size_t> missing(place_of(graph.size()), 0);
  std::vector<std::vector<NodeId>> users(place_of(graph.size()));
  std::vector<NodeId> ready, order;
  for (NodeId id = 0; id < graph.size(); ++id) {
    for (const NodeId operand : operands_of(graph[id])) {
      ++missing[place_of(id)];
      users[place_of(operand)].push_back(id);
    }
    if (missing[place_of(id)] == 0) ready.push_back(id);
  }
  std::mt19937_64 engine(seed);
  while (!ready.empty()) {
    std::swap(ready[engine() % ready.size()], ready.back());
    order.push_back(ready.back());
    ready.pop_back();
    for (const NodeId user : users[place_of(order.back())]) {
      if (--missing[place_of(user)] == 0) ready.push_back(user);
    }
  }
  return order;
}

}  // namespace

Function reordered(Function function, unsigned seed) {
  if (seed == 0) return function;
  Graph graph;
  std::vector<NodeId> image(place_of(function.graph.size()), -1);
  for (const NodeId id : random_order(function.graph, seed)) {
    image[place_of(id)] = graph.copy(function.graph[id], image);
    copy_name(function.graph, id, graph, image[place_of(id)]);
  }
  return with_graph(function, std::move(graph), image);
}

}  // namespace flatdyn
