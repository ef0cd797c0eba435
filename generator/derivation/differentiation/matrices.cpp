// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <optional>
#include <utility>

#include "derivation/differentiation/derivative_outputs.hpp"
#include "derivation/differentiation/differentiate.hpp"
#include "derivation/differentiation/modes.hpp"
#include "graph/count.hpp"

namespace flatdyn {
namespace {

// Unit vector number k of a space.
std::vector<std::optional<NodeId>> unit_direction(int k, const Tangents& tangents, Graph& graph) {
  std::vector<std::optional<NodeId>> direction(static_cast<std::size_t>(tangents.count()));
  direction[static_cast<std::size_t>(k)] = graph.constant(1);
  return direction;
}

std::vector<NodeId> entries_of(const Function& function) {
  std::vector<NodeId> entries;
  for (const Output& output : function.outputs) {
    entries.insert(entries.end(), output.entries.begin(), output.entries.end());
  }
  return entries;
}

JacobianColumns columns_in_forward_mode(const Function& function, const Tangents& tangents, Graph& graph) {
  const std::vector<NodeId> entries = entries_of(function);
  const std::vector<bool> is_used = reachable_from(function.graph, entries);
  JacobianColumns columns;
  for (int k = 0; k < tangents.count(); ++k) {
    ForwardMode forward(is_used, tangents, unit_direction(k, tangents, graph), graph);
    columns.emplace_back();
    for (const NodeId entry : entries) columns.back().push_back(forward.rate(entry));
  }
  return columns;
}

JacobianColumns columns_in_reverse_mode(const Function& function, const Tangents& tangents, Graph& graph) {
  const auto nodes = static_cast<std::size_t>(function.graph.size());
  JacobianColumns columns(static_cast<std::size_t>(tangents.count()));
  for (const NodeId entry : entries_of(function)) {
    std::vector<std::vector<Term>> weights(nodes);
    weights[static_cast<std::size_t>(entry)].push_back({1, graph.constant(1)});
    const std::vector<NodeId> row = ReverseMode(tangents, graph, std::move(weights)).derivatives();
    for (std::size_t k = 0; k < columns.size(); ++k) columns[k].push_back(row[k]);
  }
  return columns;
}

Function cheaper(Function a, Function b) {
  return count_operations(b).arithmetic() < count_operations(a).arithmetic() ? std::move(b) : std::move(a);
}

}  // namespace

Function jacobian_matrices(const Function& function, const Tangents& tangents) {
  Function forward = function, reverse = function;
  forward.outputs =
      jacobian_outputs(function.outputs, tangents, columns_in_forward_mode(function, tangents, forward.graph));
  reverse.outputs =
      jacobian_outputs(function.outputs, tangents, columns_in_reverse_mode(function, tangents, reverse.graph));
  return cheaper(std::move(forward), std::move(reverse));
}

Function contracted_hessian(const Function& function, const Tangents& tangents) {
  const Function gradient = vector_times_jacobian(function, tangents);
  Function all = gradient;
  const JacobianColumns columns = columns_in_forward_mode(gradient, tangents, all.graph);
  std::optional<Function> best;
  for (const HessianOrder order :
       {HessianOrder{true, true}, HessianOrder{true, false}, HessianOrder{false, true}, HessianOrder{false, false}}) {
    all.outputs = hessian_outputs(all.graph, tangents, order, columns);
    best = best ? cheaper(std::move(*best), all) : all;
  }
  return *best;
}

}  // namespace flatdyn
