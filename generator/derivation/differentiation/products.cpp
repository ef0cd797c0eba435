// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <utility>

#include "derivation/differentiation/derivative_outputs.hpp"
#include "derivation/differentiation/differentiate.hpp"
#include "derivation/differentiation/modes.hpp"

namespace flatdyn {

Function jacobian_times_vector(const Function& function, const Tangents& tangents) {
  Function result = without_outputs(function, InputKind::direction, tangents.count(),
                                    "a direction: the rates of " + tangents.words_for_all());
  std::vector<std::optional<NodeId>> direction;
  for (int k = 0; k < tangents.count(); ++k) direction.emplace_back(result.graph.input({InputKind::direction, k}));
  ForwardMode forward(reachable_from(function.graph, roots(function)), tangents, direction, result.graph);
  for (Output output : function.outputs) {
    for (NodeId& entry : output.entries) entry = forward.rate(entry);
    output.meaning = fmt::format("the rate of {} along the direction: {}", output.name, output.meaning);
    output.name = "d" + output.name;
    result.outputs.push_back(std::move(output));
  }
  return result;
}

Function vector_times_jacobian(const Function& function, const Tangents& tangents) {
  const std::string entries = words_for_entries(function);
  Function result = without_outputs(function, InputKind::weights, static_cast<int>(entry_count(function)),
                                    fmt::format("weights of {}", entries));
  std::vector<std::vector<Term>> weights(static_cast<std::size_t>(result.graph.size()));
  int place = 0;
  for (const Output& output : function.outputs) {
    for (const NodeId entry : output.entries) {
      weights[static_cast<std::size_t>(entry)].push_back({1, result.graph.input({InputKind::weights, place++})});
    }
  }
  const std::vector<NodeId> derivatives = ReverseMode(tangents, result.graph, std::move(weights)).derivatives();
  result.outputs = gradient_outputs(derivatives, tangents, entries);
  return result;
}

}  // namespace flatdyn
