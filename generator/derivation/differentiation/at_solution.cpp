// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/differentiation/at_solution.hpp"

#include <optional>

#include "graph/passes/substitution.hpp"

namespace flatdyn {

std::vector<Output> outputs_at(const Function& function, const std::vector<NodeId>& accelerations,
                               const std::vector<NodeId>& weights, Graph& graph) {
  const auto image_of = [&](const Input& input, Graph&) -> std::optional<NodeId> {
    const auto k = static_cast<std::size_t>(input.index);
    if (is_acceleration(input.kind)) return accelerations[k];
    if (input.kind == InputKind::weights) return weights[k];
    return std::nullopt;
  };
  return substituted_outputs(function, image_of, graph);
}

}  // namespace flatdyn
