// SPDX-License-Identifier: GPL-2.0-or-later
#include "graph/well_formed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace flatdyn {
namespace {

using Complaint = std::optional<std::string>;

Complaint check_sum(const Graph& graph, const Node& node) {
  if (node.terms.empty()) return "a sum without terms";
  for (std::size_t k = 0; k < node.terms.size(); ++k) {
    const Term& term = node.terms[k];
    if (k > 0 && node.terms[k - 1].node >= term.node) return "terms out of order, or twice the same";
    if (term.coefficient.is_zero()) return "a term with coefficient 0";
    if (graph.is_constant(term.node)) return "a constant among the terms";
    if (!graph.is_scaled(term.node)) continue;
    if (is_scaled(node)) return "a scaled node of a scaled node";
    if (abs(term.coefficient) != 1) return "a coefficient on a scaled node";
    if (graph[term.node].terms[0].coefficient == -1) return "a mere sign change as a term";
  }
  if (is_scaled(node)) {
    if (node.terms[0].coefficient == 1) return "a node scaled by 1";
  } else if (node.terms[0].coefficient < 0) {
    return "a sum whose first term is negative";
  }
  return {};
}

Complaint check_product(const Graph& graph, const Node& node) {
  if (node.operands.size() < 2) return "a product of less than two factors";
  if (!std::is_sorted(node.operands.begin(), node.operands.end())) return "factors out of order";
  for (const NodeId factor : node.operands) {
    if (graph.is_constant(factor)) return "a constant among the factors";
    if (graph.is_scaled(factor) && graph[factor].terms[0].coefficient == -1) return "a mere sign change as a factor";
  }
  return {};
}

Complaint check_quotient(const Graph& graph, const Node& node) {
  if (node.operands.size() != 2) return "a quotient without two operands";
  if (graph.is_constant(node.operands[1])) return "a quotient by a constant";
  if (graph.is_scaled(node.operands[0]) || graph.is_scaled(node.operands[1])) return "a quotient of a scaled node";
  if (graph.is_constant(node.operands[0]) && graph[node.operands[0]].value <= 0) return "a quotient of a constant <= 0";
  return {};
}

Complaint check_unary(const Graph& graph, const Node& node) {
  if (node.operands.size() != 1) return "not one operand";
  const NodeId operand = node.operands[0];
  if (node.op == Op::sqrt) {
    if (graph.is_zero(operand)) return "the square root of 0";
  } else if (node.op == Op::sign) {
    if (graph.is_constant(operand) || graph.is_scaled(operand)) return "the sign of a constant or a scaled node";
  } else if (graph.is_zero(operand)) {
    return "sin, cos or tanh of 0";
  } else if (graph.is_scaled(operand) && graph[operand].terms[0].coefficient < 0) {
    return "sin, cos or tanh of a negative angle";
  }
  return {};
}

Complaint check_node(const Graph& graph, const Node& node) {
  switch (node.op) {
    case Op::sum:
      return check_sum(graph, node);
    case Op::product:
      return check_product(graph, node);
    case Op::quotient:
      return check_quotient(graph, node);
    case Op::sin:
    case Op::cos:
    case Op::sign:
    case Op::sqrt:
    case Op::tanh:
      return check_unary(graph, node);
    case Op::constant:
    case Op::input:
      return {};
  }
  return "no known op";
}

Complaint check_graph(const Graph& graph) {
  for (NodeId id = 0; id < graph.size(); ++id) {
    for (const NodeId operand : operands_of(graph[id])) {
      if (operand < 0 || operand >= id) return fmt::format("node {}: operand {} does not precede it", id, operand);
    }
    if (const Complaint complaint = check_node(graph, graph[id])) return fmt::format("node {}: {}", id, *complaint);
  }
  // Applied to the graph's own nodes, the constructors must find exactly these and add no others.
  Graph again = graph;
  std::vector<NodeId> identity(static_cast<std::size_t>(graph.size()));
  std::iota(identity.begin(), identity.end(), 0);
  for (NodeId id = 0; id < graph.size(); ++id) {
    if (again.copy(graph[id], identity) != id) return fmt::format("node {}: its copy is another node", id);
  }
  return {};
}

Complaint check_outputs(const Function& function) {
  for (const Output& output : function.outputs) {
    if (output.entries.size() != static_cast<std::size_t>(output.rows) * static_cast<std::size_t>(output.cols)) {
      return fmt::format("output {}: {} entries for {} x {}", output.name, output.entries.size(), output.rows,
                         output.cols);
    }
  }
  for (const NodeId root : roots(function)) {
    if (root < 0 || root >= function.graph.size()) return fmt::format("root {} does not exist", root);
  }
  return {};
}

}  // namespace

std::optional<std::string> check_well_formed(const Function& function) {
  if (Complaint complaint = check_graph(function.graph)) return complaint;
  if (Complaint complaint = check_outputs(function)) return complaint;
  for (const Input& input : inputs_read(function)) {
    if (std::find(function.inputs.begin(), function.inputs.end(), input.kind) == function.inputs.end()) {
      return fmt::format("an input of kind {} is read, but not declared", static_cast<int>(input.kind));
    }
  }
  return {};
}

}  // namespace flatdyn
