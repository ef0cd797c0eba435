// SPDX-License-Identifier: GPL-2.0-or-later
#include "graph/function.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace flatdyn {

bool Output::is_written() const {
  return left_out.empty() ? !entries.empty() : std::find(left_out.begin(), left_out.end(), false) != left_out.end();
}

std::vector<NodeId> roots(const Function& function) {
  std::vector<NodeId> all;
  for (const Output& output : function.outputs) all.insert(all.end(), output.entries.begin(), output.entries.end());
  all.insert(all.end(), function.validity_conditions.begin(), function.validity_conditions.end());
  all.insert(all.end(), function.pivot_scales.begin(), function.pivot_scales.end());
  return all;
}

// The members are copied one by one, so that the old graph is not copied along.
Function with_graph(const Function& function, Graph graph, const std::vector<NodeId>& image) {
  Function result{.name = function.name,
                  .summary = function.summary,
                  .equation = function.equation,
                  .formulation = function.formulation,
                  .inputs = function.inputs,
                  .base_parameters = function.base_parameters,
                  .own = function.own,
                  .at_rest = function.at_rest,
                  .task = function.task,
                  .graph = std::move(graph),
                  .outputs = function.outputs,
                  .validity_conditions = function.validity_conditions,
                  .pivot_scales = function.pivot_scales,
                  .proven_pivot_share = function.proven_pivot_share,
                  .loop_conditions = function.loop_conditions,
                  .inverted = function.inverted};
  const auto replace = [&image](NodeId& id) { id = image[static_cast<std::size_t>(id)]; };
  for (Output& output : result.outputs) std::for_each(output.entries.begin(), output.entries.end(), replace);
  std::for_each(result.validity_conditions.begin(), result.validity_conditions.end(), replace);
  std::for_each(result.pivot_scales.begin(), result.pivot_scales.end(), replace);
  return result;
}

int own_length(const Function& function, ArgumentLength length) {
  return length == ArgumentLength::own ? function.own.length : function.base_parameters;
}

bool has_scale(const Function& function, std::size_t k) {
  return k < function.pivot_scales.size() && function.pivot_scales[k] != function.validity_conditions[k];
}

bool compares_pivots(const Function& function) {
  return !function.pivot_scales.empty() &&
         function.validity_conditions.size() > static_cast<std::size_t>(function.loop_conditions);
}

bool always_holds(const Function& function, std::size_t k) {
  const Rational safe_share{1, 1 << 16};
  const Graph& graph = function.graph;
  const NodeId id = function.validity_conditions[k];
  if (!graph.is_constant(id) || graph[id].value <= 0) return false;
  if (k >= function.pivot_scales.size()) return true;
  const NodeId scale = function.pivot_scales[k];
  return graph.is_constant(scale) && graph[id].value >= safe_share * graph[scale].value;
}

bool computes_angles(const Function& function) {
  const std::vector<bool> alive = reachable_from(function.graph, roots(function));
  for (NodeId id = 0; id < function.graph.size(); ++id) {
    if (alive[static_cast<std::size_t>(id)] && is_of_computed_angle(function.graph, id)) return true;
  }
  return false;
}

std::size_t entry_count(const Function& function) {
  std::size_t count = 0;
  for (const Output& output : function.outputs) count += output.entries.size();
  return count;
}

bool is_whole(const Function& function) {
  return std::all_of(function.outputs.begin(), function.outputs.end(),
                     [](const Output& output) { return output.left_out.empty(); });
}

std::vector<Input> inputs_read(const Function& function) {
  const std::vector<bool> alive = reachable_from(function.graph, roots(function));
  std::vector<Input> inputs;
  for (NodeId id = 0; id < function.graph.size(); ++id) {
    const Node& node = function.graph[id];
    if (alive[static_cast<std::size_t>(id)] && node.op == Op::input) inputs.push_back(node.input);
  }
  std::sort(inputs.begin(), inputs.end(),
            [](const Input& a, const Input& b) { return std::tie(a.kind, a.index) < std::tie(b.kind, b.index); });
  return inputs;
}

}  // namespace flatdyn
