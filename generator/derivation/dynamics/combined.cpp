// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/combined.hpp"

#include <algorithm>

#include "graph/fusion.hpp"

namespace flatdyn {
namespace {

// Row i of B times the inputs of one kind.
std::vector<Term> row_times(Graph& graph, const Output& B, int i, InputKind kind) {
  std::vector<Term> terms;
  for (int j = 0; j < B.cols; ++j) {
    const NodeId entry = B.entries[static_cast<std::size_t>(i * B.cols + j)];
    terms.push_back({1, graph.product({entry, graph.input({kind, j})})});
  }
  return terms;
}

InputKind acceleration_of(const Function& torques) {
  const auto& kinds = torques.inputs;
  const bool floats = std::find(kinds.begin(), kinds.end(), InputKind::a) != kinds.end();
  return with_base(InputKind::qdd, floats);
}

}  // namespace

Function from_inertia_matrix(const Function& torques, const Function& inertia_matrix, const Function& bias) {
  const Function parts = fused({inertia_matrix, bias}).function;
  const Output &B = parts.outputs[0], &n = parts.outputs[1];
  Function result = torques;
  result.graph = parts.graph;
  for (int i = 0; i < B.rows; ++i) {
    std::vector<Term> terms = row_times(result.graph, B, i, acceleration_of(torques));
    terms.push_back({1, n.entries[static_cast<std::size_t>(i)]});
    result.outputs[0].entries[static_cast<std::size_t>(i)] = result.graph.sum(terms);
  }
  return result;
}

Function from_inertia_matrix(const Function& energy, const Function& inertia_matrix) {
  const Output& B = inertia_matrix.outputs[0];
  const InputKind velocity = *std::find_if(energy.inputs.begin(), energy.inputs.end(), is_velocity);
  Function result = energy;
  result.graph = inertia_matrix.graph;
  std::vector<Term> halves;
  for (int i = 0; i < B.rows; ++i) {
    const NodeId momentum = result.graph.sum(row_times(result.graph, B, i, velocity));
    halves.push_back({Rational(1) / 2, result.graph.product({momentum, result.graph.input({velocity, i})})});
  }
  result.outputs[0].entries = {result.graph.sum(halves)};
  return result;
}

}  // namespace flatdyn
