// SPDX-License-Identifier: GPL-2.0-or-later
#include "graph/passes/fuse_products.hpp"

#include <algorithm>
#include <map>

namespace flatdyn {
namespace {

bool is_sign(const Rational& coefficient) { return abs(coefficient) == 1; }
bool is_sum_of_several(const Node& node) {
  return node.op == Op::sum && node.terms.size() + (node.value.is_zero() ? 0 : 1) > 1;
}

class Chooser {
 public:
  explicit Chooser(const Function& function)
      : graph_(function.graph),
        alive_(reachable_from(graph_, roots(function))),
        is_fused_(alive_.size(), false),
        in_sums_(alive_.size(), 0) {
    find_candidates(function);
  }

  std::vector<bool> run() {
    std::vector<NodeId> without_start;
    for (NodeId id = 0; id < graph_.size(); ++id) {
      if (at(alive_, id) && is_sum_of_several(graph_[id]) && has_only_products(graph_[id])) without_start.push_back(id);
    }
    compute_starts(std::move(without_start));
    return std::move(is_fused_);
  }

 private:
  template <class T>
  static auto at(std::vector<T>& values, NodeId id) -> decltype(values[0]) {
    return values[static_cast<std::size_t>(id)];
  }

  // Products that are used in sums only, not multiplied by a number.
  void find_candidates(const Function& function) {
    std::vector<int> elsewhere(alive_.size(), 0);
    for (const NodeId root : roots(function)) ++at(elsewhere, root);
    for (NodeId id = 0; id < graph_.size(); ++id) {
      if (!at(alive_, id)) continue;
      const Node& node = graph_[id];
      for (const Term& term : node.terms) {
        ++at(is_sum_of_several(node) && is_sign(term.coefficient) ? in_sums_ : elsewhere, term.node);
      }
      for (const NodeId operand : node.operands) ++at(elsewhere, operand);
    }
    for (NodeId id = 0; id < graph_.size(); ++id) {
      const bool is_used_by_sums = at(alive_, id) && graph_[id].op == Op::product && at(elsewhere, id) == 0;
      at(is_fused_, id) = is_used_by_sums && (graph_[id].operands.size() == 2 || at(in_sums_, id) == 1);
    }
  }

  bool has_only_products(const Node& sum) {
    return sum.value.is_zero() && std::all_of(sum.terms.begin(), sum.terms.end(), [this](const Term& term) {
             return !is_sign(term.coefficient) || at(is_fused_, term.node);
           });
  }

  // Computes products that several of these sums can start with, those of most sums first. Sums that are left start
  // with a product that no other one starts with.
  void compute_starts(std::vector<NodeId> sums) {
    for (;;) {
      std::map<NodeId, int> starts;
      for (const NodeId sum : sums) {
        for (const Term& term : graph_[sum].terms) starts[term.node] += at(is_fused_, term.node) ? 1 : 0;
      }
      const auto best = std::max_element(starts.begin(), starts.end(),
                                         [](const auto& a, const auto& b) { return a.second < b.second; });
      if (best == starts.end() || best->second < 2) return;
      at(is_fused_, best->first) = false;
      std::erase_if(sums, [this](NodeId sum) { return !has_only_products(graph_[sum]); });
    }
  }

  const Graph& graph_;
  std::vector<bool> alive_, is_fused_;
  std::vector<int> in_sums_;
};

}  // namespace

std::vector<bool> products_to_fuse(const Function& function) { return Chooser(function).run(); }

OperationCount operations_as_written(const Function& function, bool fuses) {
  if (!fuses) return count_operations(function);
  const std::vector<bool> is_fused = products_to_fuse(function);
  const Graph& graph = function.graph;
  OperationCount count = count_operations(function);
  const std::vector<bool> alive = reachable_from(graph, roots(function));
  for (NodeId id = 0; id < graph.size(); ++id) {
    const auto at = static_cast<std::size_t>(id);
    if (!alive[at]) continue;
    const Node& node = graph[id];
    if (is_fused[at]) count.multiplications -= static_cast<int>(node.operands.size()) - 1;
    if (!is_sum_of_several(node)) continue;
    int products = 0;
    for (const Term& term : node.terms) {
      const bool is_product = is_fused[static_cast<std::size_t>(term.node)];
      products += is_product || !is_sign(term.coefficient) ? 1 : 0;
      // The product of all factors but the last, which is fused; a number is a factor that has been counted.
      if (is_product) count.multiplications += static_cast<int>(graph[term.node].operands.size()) - 1;
    }
    const int summands = static_cast<int>(node.terms.size()) + (node.value.is_zero() ? 0 : 1);
    const int fused = std::min(products, summands - 1);
    count.multiplications -= fused;
    count.additions -= fused;
    count.fused += fused;
  }
  return count;
}

}  // namespace flatdyn
