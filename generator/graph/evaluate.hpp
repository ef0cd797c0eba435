// SPDX-License-Identifier: GPL-2.0-or-later
// Evaluation of a Function over any scalar: double, 50 digits, a prime field.
#pragma once

#include <vector>

#include "graph/function.hpp"
#include "graph/rational_tanh.hpp"

namespace flatdyn {

// evaluate() computes the values of all nodes that `roots(function)` reach; the values of the others are
// default-constructed. An Arithmetic defines the scalar type and its operations, which need not include real
// trigonometry:
//   using Scalar
//   Scalar constant(const Rational&)
//   Scalar input(const Input&)
//   Scalar divide(const Scalar&, const Scalar&)
//   Scalar sin(const Graph&, NodeId angle, const Scalar& angle_value)
//   Scalar cos(const Graph&, NodeId angle, const Scalar& angle_value)
//   Scalar sign(const Scalar&)
//   Scalar sqrt(const Scalar&)
//   Scalar tanh(const Scalar&)     without it, rational_tanh() is taken
template <class Arithmetic>
std::vector<typename Arithmetic::Scalar> evaluate(const Function& function, Arithmetic& arithmetic) {
  using Scalar = typename Arithmetic::Scalar;
  const Graph& graph = function.graph;
  const std::vector<bool> alive = reachable_from(graph, roots(function));
  std::vector<Scalar> values(static_cast<std::size_t>(graph.size()));
  const auto at = [&values](NodeId id) -> Scalar& { return values[static_cast<std::size_t>(id)]; };
  for (NodeId id = 0; id < graph.size(); ++id) {
    if (!alive[static_cast<std::size_t>(id)]) continue;
    const Node& node = graph[id];
    switch (node.op) {
      case Op::constant:
        at(id) = arithmetic.constant(node.value);
        break;
      case Op::input:
        at(id) = arithmetic.input(node.input);
        break;
      case Op::sum: {
        Scalar total = arithmetic.constant(node.value);
        for (const Term& term : node.terms) total += arithmetic.constant(term.coefficient) * at(term.node);
        at(id) = total;
        break;
      }
      case Op::product: {
        Scalar total = at(node.operands[0]);
        for (std::size_t k = 1; k < node.operands.size(); ++k) total *= at(node.operands[k]);
        at(id) = total;
        break;
      }
      case Op::quotient:
        at(id) = arithmetic.divide(at(node.operands[0]), at(node.operands[1]));
        break;
      case Op::sin:
        at(id) = arithmetic.sin(graph, node.operands[0], at(node.operands[0]));
        break;
      case Op::cos:
        at(id) = arithmetic.cos(graph, node.operands[0], at(node.operands[0]));
        break;
      case Op::sign:
        at(id) = arithmetic.sign(at(node.operands[0]));
        break;
      case Op::sqrt:
        at(id) = arithmetic.sqrt(at(node.operands[0]));
        break;
      case Op::tanh:
        at(id) = tanh_in(arithmetic, at(node.operands[0]));
        break;
    }
  }
  return values;
}

}  // namespace flatdyn
