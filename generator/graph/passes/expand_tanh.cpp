// SPDX-License-Identifier: GPL-2.0-or-later
#include "graph/passes/expand_tanh.hpp"

#include <utility>

#include "graph/passes/draft.hpp"
#include "graph/rational_tanh.hpp"

namespace flatdyn {
namespace {

// Builds the nodes of one tanh after the other. x/4 is shared, not folded into its users.
class TanhExpansion {
 public:
  explicit TanhExpansion(Graph& graph) : graph_(graph) {}

  NodeId of(NodeId x) {
    const NodeId f = half_clamped(graph_.scaled(Rational(1, 4), x));
    const NodeId u = graph_.scaled(Rational(1, 4), product(f, f));
    const NodeId P = polynomial(TanhConstants::kP, u), N = product(u, polynomial(TanhConstants::kR, u));
    const NodeId Q = sum(P, N);
    const NodeId N_2 = sum(product(N, Q), product(u, product(P, P))), Q_2 = sum(product(P, Q), N_2);
    const NodeId t = graph_.sum_without_folding({{1, f}, {-1, product(f, graph_.quotient(N_2, Q_2))}});
    return graph_.scaled(2, graph_.quotient(t, graph_.sum({{1, product(t, t)}}, 1)));
  }

 private:
  NodeId sum(NodeId a, NodeId b) { return graph_.sum_without_folding({{1, a}, {1, b}}); }
  NodeId product(NodeId a, NodeId b) { return graph_.product_without_folding({a, b}); }

  NodeId half_clamped(NodeId quarter) {
    const Rational limit = TanhConstants::kLimit;
    const NodeId above = graph_.sign(graph_.sum_without_folding({{1, quarter}}, -limit));
    const NodeId below = graph_.sign(graph_.sum_without_folding({{1, quarter}}, limit));
    const NodeId within = graph_.sum({{1, below}, {-1, above}}), beyond = graph_.sum({{1, below}, {1, above}});
    return graph_.sum({{1, product(within, quarter)}, {limit, beyond}});
  }

  template <class Coefficients>
  NodeId polynomial(const Coefficients& coefficients, NodeId u) {
    NodeId value = graph_.constant(coefficients.back());
    for (std::size_t k = coefficients.size() - 1; k-- > 0;) {
      value = graph_.sum({{1, graph_.is_constant(value) ? graph_.product({value, u}) : product(value, u)}},
                         coefficients[k]);
    }
    return value;
  }

  Graph& graph_;
};

}  // namespace

bool has_tanh(const Function& function) {
  for (NodeId id = 0; id < function.graph.size(); ++id) {
    if (function.graph[id].op == Op::tanh) return true;
  }
  return false;
}

Function expand_tanh(const Function& function) {
  Graph graph;
  TanhExpansion expansion(graph);
  std::vector<NodeId> image;
  for (NodeId id = 0; id < function.graph.size(); ++id) {
    const Node& node = function.graph[id];
    const auto at = [&image](NodeId operand) { return image[static_cast<std::size_t>(operand)]; };
    image.push_back(node.op == Op::tanh ? expansion.of(at(node.operands[0])) : graph.copy(node, image));
    copy_name(function.graph, id, graph, image.back());
  }
  return without_dead_code(with_graph(function, std::move(graph), image));
}

}  // namespace flatdyn
