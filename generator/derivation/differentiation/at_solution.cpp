// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/differentiation/at_solution.hpp"

#include <optional>

#include "derivation/dynamics/loop_functions.hpp"
#include "graph/passes/substitution.hpp"

namespace flatdyn {

std::vector<Output> outputs_at(const Function& function, const std::vector<NodeId>& accelerations,
                               const std::vector<NodeId>& weights, Function& to) {
  const auto image_of = [&](const Input& input, Graph&) -> std::optional<NodeId> {
    const auto k = static_cast<std::size_t>(input.index);
    if (is_acceleration(input.kind)) return accelerations[k];
    if (input.kind == InputKind::weights) return weights[k];
    return std::nullopt;
  };
  const std::vector<NodeId> image = substituted(function.graph, image_of, to.graph);
  const auto moved = [&image](NodeId id) { return image[static_cast<std::size_t>(id)]; };
  const std::size_t conditions = function.validity_conditions.size();
  for (std::size_t k = conditions - static_cast<std::size_t>(function.loop_conditions); k < conditions; ++k) {
    require_loop(to, moved(function.validity_conditions[k]), moved(function.pivot_scales[k]));
  }
  std::vector<Output> outputs = function.outputs;
  for (Output& output : outputs) {
    for (NodeId& entry : output.entries) entry = moved(entry);
  }
  return outputs;
}

}  // namespace flatdyn
