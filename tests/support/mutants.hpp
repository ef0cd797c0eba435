// SPDX-License-Identifier: GPL-2.0-or-later
// Functions with a mistake, as a faulty pass would leave them.
#pragma once

#include <vector>

#include "graph/function.hpp"

namespace flatdyn::testing {

enum class MutantKind { flip_sign, drop_term, swap_trigonometry, wrong_index, wrong_operand };

// The function with one node changed; the nodes that depend on it are rebuilt.
inline Function mutant(const Function& function, NodeId victim, MutantKind mutation) {
  Graph g;
  std::vector<NodeId> moved;
  const auto now = [&moved](NodeId id) { return moved[static_cast<std::size_t>(id)]; };
  for (NodeId id = 0; id < function.graph.size(); ++id) {
    const Node& node = function.graph[id];
    std::vector<Term> terms;
    for (const Term& term : node.terms) terms.push_back({term.coefficient, now(term.node)});
    std::vector<NodeId> operands;
    for (const NodeId operand : node.operands) operands.push_back(now(operand));
    const auto is_victim = [&](MutantKind kind) { return id == victim && mutation == kind; };
    if (is_victim(MutantKind::flip_sign)) terms.back().coefficient *= -1;
    if (is_victim(MutantKind::drop_term)) terms.pop_back();
    if (is_victim(MutantKind::wrong_operand)) operands.back() = operands.front();
    switch (node.op) {
      case Op::constant:
        moved.push_back(g.constant(node.value));
        break;
      case Op::input:
        moved.push_back(
            g.input(is_victim(MutantKind::wrong_index) ? Input{node.input.kind, node.input.index + 1} : node.input));
        break;
      case Op::sum:
        moved.push_back(g.sum(terms, node.value));
        break;
      case Op::product:
        moved.push_back(g.product(operands));
        break;
      case Op::quotient:
        moved.push_back(g.quotient(operands[0], operands[1]));
        break;
      case Op::sin:
        moved.push_back(is_victim(MutantKind::swap_trigonometry) ? g.cos(operands[0]) : g.sin(operands[0]));
        break;
      case Op::cos:
        moved.push_back(is_victim(MutantKind::swap_trigonometry) ? g.sin(operands[0]) : g.cos(operands[0]));
        break;
      case Op::sign:
        moved.push_back(g.sign(operands[0]));
        break;
      case Op::sqrt:
        moved.push_back(g.sqrt(operands[0]));
        break;
      case Op::tanh:
        moved.push_back(g.tanh(operands[0]));
        break;
    }
  }
  return with_graph(function, std::move(g), moved);
}

}  // namespace flatdyn::testing
