// SPDX-License-Identifier: GPL-2.0-or-later
#include "graph/passes/draft.hpp"

#include <algorithm>
#include <utility>

#include "graph/count.hpp"

namespace flatdyn {
namespace {

constexpr NodeId kNone = -1;

std::size_t index(NodeId id) { return static_cast<std::size_t>(id); }

std::vector<bool> alive_nodes(const Draft& draft) {
  std::vector<bool> alive(draft.nodes.size(), false);
  std::vector<NodeId> stack = roots(draft.source);
  while (!stack.empty()) {
    const NodeId id = stack.back();
    stack.pop_back();
    if (alive[index(id)]) continue;
    alive[index(id)] = true;
    for (const NodeId operand : draft.at(id).operands) stack.push_back(operand);
    for (const Term& term : draft.at(id).terms) stack.push_back(term.node);
  }
  return alive;
}

// Copies `root` and its operands, operands first.
void copy_tree(const Draft& draft, NodeId root, Graph& graph, std::vector<NodeId>& image) {
  std::vector<NodeId> stack = {root};
  while (!stack.empty()) {
    const NodeId id = stack.back();
    if (image[index(id)] != kNone) {
      stack.pop_back();
      continue;
    }
    const std::size_t depth = stack.size();
    const auto need = [&](NodeId operand) {
      if (image[index(operand)] == kNone) stack.push_back(operand);
    };
    for (const NodeId operand : draft.at(id).operands) need(operand);
    for (const Term& term : draft.at(id).terms) need(term.node);
    if (stack.size() > depth) continue;
    stack.pop_back();
    image[index(id)] = graph.copy(draft.at(id), image);
    if (id < draft.source.graph.size()) copy_name(draft.source.graph, id, graph, image[index(id)]);
  }
}

// Removes nodes that folding has left without a use, such as products that had a coefficient.
Function without_leftovers(Function function) {
  const std::vector<bool> reached = reachable_from(function.graph, roots(function));
  if (std::find(reached.begin(), reached.end(), false) == reached.end()) return function;
  const std::vector<NodeId> image = function.graph.remove_all_but(reached);
  return with_graph(function, std::move(function.graph), image);
}

int cost_of(const OperationCount& count) {
  constexpr int kDivision = 5, kTrigonometric = 20;
  return count.arithmetic() + kDivision * count.divisions + kTrigonometric * count.trigonometric;
}

// Whether no scaled node and no product is an operand that could be folded into its users.
bool is_unfolded(const Graph& graph) {
  for (NodeId id = 0; id < graph.size(); ++id) {
    const Node& node = graph[id];
    for (const Term& term : node.terms) {
      if (graph.is_scaled(term.node)) return false;
    }
    if (node.op != Op::product) continue;
    for (const NodeId operand : node.operands) {
      if (graph.is_scaled(operand) || graph[operand].op == Op::product) return false;
    }
  }
  return true;
}

}  // namespace

NodeId unfolded_node(Graph& graph, const Node& node, const std::vector<NodeId>& image) {
  if (node.op == Op::sum) {
    std::vector<Term> terms = node.terms;
    for (Term& term : terms) term.node = image[index(term.node)];
    return graph.sum(std::move(terms), node.value);
  }
  if (node.op == Op::product) {
    std::vector<NodeId> factors = node.operands;
    for (NodeId& factor : factors) factor = image[index(factor)];
    return graph.product(std::move(factors));
  }
  return graph.copy(node, image);
}

Draft::Draft(const Function& function) : source(function) {
  nodes.reserve(index(function.graph.size()));
  for (NodeId id = 0; id < function.graph.size(); ++id) nodes.push_back(function.graph[id]);
}

NodeId Draft::add(Node node) {
  nodes.push_back(std::move(node));
  return static_cast<NodeId>(nodes.size()) - 1;
}

NodeId Draft::add_sum(std::vector<Term> terms, const Rational& constant) {
  Node node;
  node.op = Op::sum;
  node.terms = std::move(terms);
  node.value = constant;
  return add(std::move(node));
}

NodeId Draft::add_product(std::vector<NodeId> factors) {
  Node node;
  node.op = Op::product;
  node.operands = std::move(factors);
  return add(std::move(node));
}

std::vector<int> Draft::use_counts() const {
  const std::vector<bool> alive = alive_nodes(*this);
  std::vector<int> uses(nodes.size(), 0);
  for (const NodeId root : roots(source)) ++uses[index(root)];
  for (std::size_t id = 0; id < nodes.size(); ++id) {
    if (!alive[id]) continue;
    for (const NodeId operand : nodes[id].operands) ++uses[index(operand)];
    for (const Term& term : nodes[id].terms) ++uses[index(term.node)];
  }
  return uses;
}

Function Draft::finish() const {
  const std::vector<bool> alive = alive_nodes(*this);
  Graph graph;
  std::vector<NodeId> image(nodes.size(), kNone);
  for (std::size_t id = 0; id < nodes.size(); ++id) {
    if (alive[id]) copy_tree(*this, static_cast<NodeId>(id), graph, image);
  }
  return without_leftovers(with_graph(source, std::move(graph), image));
}

Function without_dead_code(const Function& function) {
  const std::vector<bool> alive = reachable_from(function.graph, roots(function));
  Graph graph;
  std::vector<NodeId> image(alive.size(), kNone);
  for (std::size_t id = 0; id < alive.size(); ++id) {
    if (!alive[id]) continue;
    const NodeId old = static_cast<NodeId>(id);
    image[id] = graph.copy(function.graph[old], image);
    copy_name(function.graph, old, graph, image[id]);
  }
  return with_graph(function, std::move(graph), image);
}

Function unfolded(Function function) {
  const std::vector<bool> alive = reachable_from(function.graph, roots(function));
  if (is_unfolded(function.graph) && std::find(alive.begin(), alive.end(), false) == alive.end()) return function;
  Graph graph;
  std::vector<NodeId> image(alive.size(), kNone);
  for (std::size_t id = 0; id < alive.size(); ++id) {
    if (!alive[id]) continue;
    const NodeId old = static_cast<NodeId>(id);
    image[id] = unfolded_node(graph, function.graph[old], image);
    copy_name(function.graph, old, graph, image[id]);
  }
  return without_leftovers(with_graph(function, std::move(graph), image));
}

bool is_worth_repeating(int cost_before, int cost_after) {
  constexpr int kLeastGain = 400;  // one operation in this many
  return (cost_before - cost_after) * kLeastGain >= cost_before && cost_after < cost_before;
}

int cost(const Function& function) { return cost_of(count_operations(function)); }

Function cheaper(Function original, Function candidate) {
  const OperationCount before = count_operations(original), after = count_operations(candidate);
  const bool worse = after.divisions > before.divisions || after.trigonometric > before.trigonometric;
  return worse || cost_of(after) >= cost_of(before) ? std::move(original) : std::move(candidate);
}

}  // namespace flatdyn
