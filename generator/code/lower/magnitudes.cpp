// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/lower/magnitudes.hpp"

#include <cmath>

namespace flatdyn {
namespace {

double magnitude_of(InputKind kind) {
  switch (argument_row(kind).quantity) {
    case ArgumentQuantity::velocity:
      return 3;
    case ArgumentQuantity::duration:
      return 0.01;
    case ArgumentQuantity::acceleration:
    case ArgumentQuantity::torque:
    case ArgumentQuantity::wrench:
    case ArgumentQuantity::gravity:
      return 10;
    default:
      return 1;
  }
}

}  // namespace

std::vector<double> typical_magnitudes(const Graph& graph) {
  constexpr double kSine = 0.7;
  std::vector<double> magnitudes(static_cast<std::size_t>(graph.size()), 1);
  const auto at = [&](NodeId id) { return magnitudes[static_cast<std::size_t>(id)]; };
  for (NodeId id = 0; id < graph.size(); ++id) {
    const Node& node = graph[id];
    double& magnitude = magnitudes[static_cast<std::size_t>(id)];
    switch (node.op) {
      case Op::constant:
        magnitude = std::abs(node.value.truncated());
        break;
      case Op::input:
        magnitude = magnitude_of(node.input.kind);
        break;
      case Op::sum: {
        double squares = std::pow(node.value.truncated(), 2);
        for (const Term& term : node.terms) squares += std::pow(term.coefficient.truncated() * at(term.node), 2);
        magnitude = std::sqrt(squares);
        break;
      }
      case Op::product:
        for (const NodeId factor : node.operands) magnitude *= at(factor);
        break;
      case Op::quotient:
        magnitude = at(node.operands[0]) / at(node.operands[1]);
        break;
      case Op::sin:
      case Op::cos:
        magnitude = kSine;
        break;
      case Op::sign:
      case Op::tanh:
        break;
      case Op::sqrt:
        magnitude = std::sqrt(at(node.operands[0]));
        break;
    }
  }
  return magnitudes;
}

}  // namespace flatdyn
