// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/differentiation/differentiable.hpp"

#include <optional>
#include <utility>

#include "graph/passes/substitution.hpp"

namespace flatdyn {

Differentiable::Differentiable(const Mechanism& mechanism, Function function, const std::vector<InputKind>& arguments,
                               const Choices& choices)
    : function_(std::move(function)), tangents_(mechanism, arguments, function_.base_parameters) {
  if (!mechanism.has_loops()) return;
  LoopRates rates = derive_loop_rates(mechanism, choices);
  const auto same = [](const Input&, Graph&) -> std::optional<NodeId> { return std::nullopt; };
  const std::vector<NodeId> image = substituted(rates.graph, same, function_.graph);
  const auto moved = [&image](NodeId id) { return image[static_cast<std::size_t>(id)]; };
  for (NodeId& entry : rates.G) entry = moved(entry);
  for (const ClosedLoops::Condition& each : rates.conditions) {
    conditions_.push_back({moved(each.reciprocal), moved(each.value), moved(each.scale)});
  }
  tangents_.move_along(std::move(rates.G));
}

Function Differentiable::finished(Function derivative) const {
  std::vector<NodeId> entries;
  for (const Output& output : derivative.outputs) {
    entries.insert(entries.end(), output.entries.begin(), output.entries.end());
  }
  const std::vector<bool> is_used = reachable_from(derivative.graph, entries);
  for (const ClosedLoops::Condition& condition : conditions_) {
    if (is_used[static_cast<std::size_t>(condition.reciprocal)]) {
      require_loop(derivative, condition.value, condition.scale);
    }
  }
  return derivative;
}

}  // namespace flatdyn
