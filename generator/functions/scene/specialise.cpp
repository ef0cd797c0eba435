// SPDX-License-Identifier: GPL-2.0-or-later
#include "functions/scene/specialise.hpp"

#include <algorithm>
#include <utility>

#include "functions/function_table.hpp"
#include "functions/scene/entries.hpp"
#include "graph/passes/draft.hpp"
#include "graph/passes/substitution.hpp"

namespace flatdyn {
namespace {

void leave_out(const std::vector<std::vector<bool>>& wanted, Function& function) {
  const NodeId zero = function.graph.constant(0);
  for (std::size_t k = 0; k < function.outputs.size(); ++k) {
    Output& output = function.outputs[k];
    if (std::find(wanted[k].begin(), wanted[k].end(), false) == wanted[k].end()) continue;
    output.left_out.resize(output.entries.size());
    for (std::size_t e = 0; e < output.entries.size(); ++e) {
      output.left_out[e] = !wanted[k][e];
      if (output.left_out[e]) output.entries[e] = zero;
    }
  }
}

}  // namespace

Function at_rest(const Function& function) {
  const std::vector<InputKind>& inputs = function.inputs;
  if (std::none_of(inputs.begin(), inputs.end(), is_velocity)) return function;
  Graph still;
  const std::vector<NodeId> image = substituted(
      function.graph,
      [](const Input& input, Graph& to) {
        return is_velocity(input.kind) ? std::optional(to.constant(0)) : std::nullopt;
      },
      still);
  Function result = with_graph(function, std::move(still), image);
  result.at_rest = true;
  return without_dead_code(result);
}

Function with_outputs(const Function& function, const Mechanism& mechanism, const SceneOutputs& wanted,
                      Diagnostics& diagnostics) {
  if (row_of(function).traits.is_all_or_nothing) {
    diagnostics.unsupported(wanted.function.place, "outputs: " + function.name + " cannot be made in part",
                            "ask for the function in `functions`");
    return function;
  }
  std::vector<std::vector<bool>> is_wanted;
  for (const Output& output : function.outputs) is_wanted.emplace_back(output.entries.size(), false);
  for (const Reference& text : wanted.entries) {
    try {
      const EntrySelection selection = selected_entries(function, mechanism, text.name);
      for (const std::size_t entry : selection.entries) is_wanted[selection.output][entry] = true;
    } catch (const Failure& failure) {
      diagnostics.error(text.place, "outputs, " + function.name + ", \"" + text.name + "\": " + failure.what(),
                        failure.hint());
    }
  }
  Function result = function;
  leave_out(is_wanted, result);
  return without_dead_code(result);
}

Function specialised(const Function& function, const Mechanism& mechanism, const Scene& scene,
                     Diagnostics& diagnostics) {
  const FunctionRow* row = find_row(function.name);
  const bool is_still = scene.at_rest && (row == nullptr || !row->traits.leaves_rest);
  Function result = is_still ? at_rest(function) : function;
  for (const SceneOutputs& wanted : scene.outputs) {
    if (wanted.function.name == function.name) result = with_outputs(result, mechanism, wanted, diagnostics);
  }
  return result;
}

}  // namespace flatdyn
