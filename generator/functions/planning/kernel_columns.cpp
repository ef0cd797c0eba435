// SPDX-License-Identifier: GPL-2.0-or-later
#include "functions/planning/kernel_columns.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "derivation/dynamics/derivative_functions.hpp"
#include "graph/count.hpp"
#include "graph/passes/draft.hpp"
#include "graph/passes/passes.hpp"

namespace flatdyn {
namespace {

constexpr std::size_t kByPosition = 0, kByRate = 1, kInverse = 2;  // the outputs

// By entry of the output: the first entry with the same value, -1 for a zero.
std::vector<int> first_places(const Function& function, const Output& output) {
  std::vector<int> places;
  std::map<NodeId, int> first;
  for (std::size_t k = 0; k < output.entries.size(); ++k) {
    const NodeId entry = output.entries[k];
    places.push_back(function.graph.is_zero(entry) ? -1 : first.emplace(entry, static_cast<int>(k)).first->second);
  }
  return places;
}

// The number of entries in the outputs before this one.
int entries_before(const Function& function, std::size_t output) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < output; ++k) count += function.outputs[k].entries.size();
  return static_cast<int>(count);
}

// The columns by q and q̇ from the choices that cost least, of those without masses kept back, which may cost digits.
Function cheapest_columns(const Mechanism& mechanism, const std::vector<int>& inverse) {
  std::optional<Function> best;
  Choices choices;
  const auto consider = [&](const Choices& other) {
    Function columns = derive_acceleration_derivatives_from_inverse(mechanism, other, inverse);
    if (best && count_operations(columns).arithmetic() >= count_operations(*best).arithmetic()) return;
    best = std::move(columns);
    choices = other;
  };
  for (const Choices& other : plain_variants(mechanism, uniform_choices(mechanism, Grouping::i_yy))) consider(other);
  for (const Choices& other : with_other_still_frames(mechanism, choices)) consider(other);
  return run_passes(*best);
}

// The function with the values of `columns`.
Function with_columns(const Function& function, const Function& columns, int first_of_inverse) {
  Graph graph;
  std::vector<NodeId> image;
  for (NodeId id = 0; id < columns.graph.size(); ++id) {
    Node node = columns.graph[id];
    if (node.op == Op::input && node.input.kind == InputKind::stored) node.input.index += first_of_inverse;
    image.push_back(graph.copy(node, image));
    copy_name(columns.graph, id, graph, image.back());
  }
  const NodeId zero = graph.constant(0);
  Function result = with_graph(columns, std::move(graph), image);
  result.name = function.name;
  result.summary = function.summary;
  result.inputs = function.inputs;
  std::vector<Output> outputs = function.outputs;
  for (const std::size_t k : {kByPosition, kByRate}) outputs[k].entries = result.outputs[k].entries;
  std::fill(outputs[kInverse].entries.begin(), outputs[kInverse].entries.end(), zero);
  outputs[kInverse].left_out.assign(outputs[kInverse].entries.size(), true);
  result.outputs = std::move(outputs);
  result.validity_conditions = {result.graph.constant(1)};  // the entries must be finite
  return without_dead_code(result);
}

}  // namespace

std::optional<Function> reading_own_outputs(const LoadedRobot& model, const Function& function) {
  if (function.name != "forward_dynamics_derivatives" || !is_whole(function) || function.at_rest) return std::nullopt;
  const Mechanism& mechanism = effective_mechanism(model);
  return with_columns(function, cheapest_columns(mechanism, first_places(function, function.outputs[kInverse])),
                      entries_before(function, kInverse));
}

}  // namespace flatdyn
