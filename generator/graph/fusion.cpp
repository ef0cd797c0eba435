// SPDX-License-Identifier: GPL-2.0-or-later
#include "graph/fusion.hpp"

#include <algorithm>
#include <set>

#include "base/diagnostics/diagnostics.hpp"

namespace flatdyn {
namespace {

// Copies `from` into `to`; returns the node in `to` of each node of `from`.
std::vector<NodeId> copied(const Graph& from, Graph& to) {
  std::vector<NodeId> image;
  for (NodeId id = 0; id < from.size(); ++id) {
    image.push_back(to.copy(from[id], image));
    copy_name(from, id, to, image.back());
  }
  return image;
}

std::vector<NodeId> images(const std::vector<NodeId>& ids, const std::vector<NodeId>& image) {
  std::vector<NodeId> result;
  for (const NodeId id : ids) result.push_back(image[static_cast<std::size_t>(id)]);
  return result;
}

// Adds the matrices whose pivots are the function's conditions to those of the whole, in words.
void add_inverted(const Function& function, Function& whole) {
  if (function.inverted.empty() || whole.inverted.find(function.inverted) != std::string::npos) return;
  whole.inverted += (whole.inverted.empty() ? "" : " or ") + function.inverted;
}

// A fused function has one array of weights, or one direction.
void refuse_two_meanings(const Function& whole, const Function& function) {
  const bool have_both = whole.own.length > 0 && function.own.length > 0;
  if (!have_both || whole.own.meaning == function.own.meaning) return;
  throw Failure(FailureKind::unsupported,
                "functions whose weights or directions mean different things cannot be one: \"" + whole.own.meaning +
                    "\" and \"" + function.own.meaning + "\"",
                "fuse derivatives with functions that have neither");
}

}  // namespace

Fusion fused(const std::vector<Function>& functions) {
  Fusion fusion;
  Function& whole = fusion.function;
  std::set<InputKind> inputs;
  for (const Function& function : functions) {
    const std::vector<NodeId> image = copied(function.graph, whole.graph);
    for (Output output : function.outputs) {
      output.entries = images(output.entries, image);
      whole.outputs.push_back(std::move(output));
    }
    const std::vector<NodeId> conditions = images(function.validity_conditions, image),
                              scales = images(function.pivot_scales, image);
    whole.validity_conditions.insert(whole.validity_conditions.end(), conditions.begin(), conditions.end());
    whole.pivot_scales.insert(whole.pivot_scales.end(), scales.begin(), scales.end());
    inputs.insert(function.inputs.begin(), function.inputs.end());
    whole.base_parameters = std::max(whole.base_parameters, function.base_parameters);
    refuse_two_meanings(whole, function);
    if (function.own.length > 0) whole.own = function.own;
    add_inverted(function, whole);
    whole.name += (whole.name.empty() ? "" : "_") + function.name;
    whole.summary += (whole.summary.empty() ? "" : "; ") + function.summary;
    fusion.parts.push_back({function.name, function.summary, function.equation, function.inputs, function.at_rest,
                            function.task, function.outputs.size(), function.validity_conditions.size(),
                            function.pivot_scales.size(), function.proven_pivot_share, function.loop_conditions,
                            function.inverted});
  }
  whole.inputs.assign(inputs.begin(), inputs.end());
  return fusion;
}

Function function_of(const Fusion& fusion, std::size_t k) {
  std::size_t output = 0, condition = 0, scale = 0;
  for (std::size_t before = 0; before < k; ++before) {
    output += fusion.parts[before].outputs;
    condition += fusion.parts[before].conditions;
    scale += fusion.parts[before].pivot_scales;
  }
  const FusedFunction& part = fusion.parts[k];
  const auto slice = [](const auto& all, std::size_t first, std::size_t count) {
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(first);
    return std::decay_t<decltype(all)>(begin, begin + static_cast<std::ptrdiff_t>(count));
  };
  return {.name = part.name,
          .summary = part.summary,
          .equation = part.equation,
          .inputs = part.inputs,
          .base_parameters = fusion.function.base_parameters,
          .own = fusion.function.own,
          .at_rest = part.at_rest,
          .task = part.task,
          .graph = fusion.function.graph,
          .outputs = slice(fusion.function.outputs, output, part.outputs),
          .validity_conditions = slice(fusion.function.validity_conditions, condition, part.conditions),
          .pivot_scales = slice(fusion.function.pivot_scales, scale, part.pivot_scales),
          .proven_pivot_share = part.proven_pivot_share,
          .loop_conditions = part.loop_conditions,
          .inverted = part.inverted};
}

}  // namespace flatdyn
