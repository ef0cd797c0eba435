// SPDX-License-Identifier: GPL-2.0-or-later
#include "graph/passes/quotients.hpp"

#include <algorithm>

#include "graph/passes/draft.hpp"

namespace flatdyn {
namespace {

bool is_reciprocal(const Draft& draft, NodeId id) {
  const Node& node = draft.at(id);
  if (node.op != Op::quotient) return false;
  const Node& numerator = draft.at(node.operands[0]);
  return numerator.op == Op::constant && numerator.value == 1;
}

void divide_at_once(Draft& draft, NodeId id, const std::vector<int>& uses) {
  std::vector<NodeId> factors = draft.at(id).operands;
  const auto reciprocal = std::find_if(factors.begin(), factors.end(), [&](NodeId factor) {
    return uses[static_cast<std::size_t>(factor)] == 1 && is_reciprocal(draft, factor);
  });
  if (reciprocal == factors.end()) return;
  const NodeId denominator = draft.at(*reciprocal).operands[1];
  factors.erase(reciprocal);
  if (factors.size() == 1 && is_scaled(draft.at(factors[0]))) return;
  const NodeId numerator = factors.size() == 1 ? factors[0] : draft.add_product(factors);
  Node& node = draft.at(id);
  node.op = Op::quotient;
  node.operands = {numerator, denominator};
}

}  // namespace

Function quotients(const Function& function) {
  Draft draft(function);
  const std::vector<int> uses = draft.use_counts();
  for (NodeId id = 0; id < function.graph.size(); ++id) {
    if (draft.at(id).op == Op::product) divide_at_once(draft, id, uses);
  }
  return draft.finish();
}

}  // namespace flatdyn
