// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <utility>

#include "derivation/differentiation/differentiate.hpp"
#include "derivation/differentiation/modes.hpp"

namespace flatdyn {
namespace {

// The function without its outputs, over a graph that derivatives are added to.
Function beginning_of(const Function& function, InputKind own, int length, std::string meaning) {
  Function result = function;
  result.outputs.clear();
  result.inputs.push_back(own);
  result.own = {length, std::move(meaning)};
  return result;
}

// "the entries of tau", "the entries of B, row by row", "the entries of qdd, then of f_c".
std::string words_for_entries(const Function& function) {
  std::string text = "the entries of ";
  for (std::size_t k = 0; k < function.outputs.size(); ++k) {
    const Output& output = function.outputs[k];
    text += (k > 0 ? ", then of " : "") + output.name;
    if (output.layout == Layout::matrix) text += ", row by row";
  }
  return text;
}

}  // namespace

Function jacobian_times_vector(const Function& function, const Tangents& tangents) {
  Function result = beginning_of(function, InputKind::direction, tangents.count(),
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
  Function result = beginning_of(function, InputKind::weights, static_cast<int>(entry_count(function)),
                                 fmt::format("weights of {}", entries));
  std::vector<std::vector<Term>> weights(static_cast<std::size_t>(result.graph.size()));
  int place = 0;
  for (const Output& output : function.outputs) {
    for (const NodeId entry : output.entries) {
      weights[static_cast<std::size_t>(entry)].push_back({1, result.graph.input({InputKind::weights, place++})});
    }
  }
  const std::vector<NodeId> derivatives = ReverseMode(tangents, result.graph, std::move(weights)).derivatives();
  for (const TangentBlock& block : tangents.blocks()) {
    const auto first = derivatives.begin() + block.first;
    const std::string by = words_for(block);
    result.outputs.push_back({.name = name_of(block) + "_bar",
                              .layout = Layout::vector,
                              .rows = block.length,
                              .cols = 1,
                              .entries = {first, first + block.length},
                              .meaning = fmt::format("derivatives by {} of the weighted sum of {}", by, entries),
                              .quantity = OutputQuantity::derivative});
  }
  return result;
}

}  // namespace flatdyn
