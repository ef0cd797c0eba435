// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/step_stages.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "graph/passes/substitution.hpp"

namespace flatdyn {

Stages::Stages(Function of) : of_(std::move(of)), result_(of_) {
  result_.graph = Graph();
  result_.outputs.clear();
  result_.validity_conditions.clear();
  result_.pivot_scales.clear();
}

std::vector<NodeId> Stages::arguments(InputKind kind) {
  std::vector<NodeId> nodes;
  for (int k = 0; k < of_.outputs.at(0).rows; ++k) nodes.push_back(graph().input({kind, k}));
  return nodes;
}

std::vector<std::vector<NodeId>> Stages::outputs_at(const std::vector<NodeId>& q, const std::vector<NodeId>& qd) {
  ++stages_;
  const std::vector<NodeId> image = substituted(
      of_.graph,
      [&](const Input& input, Graph&) -> std::optional<NodeId> {
        if (input.kind == InputKind::q) return q[static_cast<std::size_t>(input.index)];
        if (input.kind == InputKind::qd) return qd[static_cast<std::size_t>(input.index)];
        return std::nullopt;
      },
      graph());
  const auto add_images = [&image](const std::vector<NodeId>& from, std::vector<NodeId>& to) {
    for (const NodeId id : from) to.push_back(image[static_cast<std::size_t>(id)]);
  };
  add_images(of_.validity_conditions, result_.validity_conditions);
  add_images(of_.pivot_scales, result_.pivot_scales);
  std::vector<std::vector<NodeId>> outputs;
  for (const Output& output : of_.outputs) add_images(output.entries, outputs.emplace_back());
  return outputs;
}

std::vector<NodeId> Stages::after(const std::string& name, const std::vector<NodeId>& x, const Rational& factor,
                                  const std::vector<NodeId>& rate) {
  const NodeId part = graph().scaled(factor, step_length());
  std::vector<NodeId> result;
  for (std::size_t k = 0; k < x.size(); ++k) {
    result.push_back(graph().sum({{1, x[k]}, {1, graph().product({part, rate[k]})}}));
    graph().set_name(result.back(), fmt::format("{}_stage{}_{}", name, stages_ + 1, k + 1));
  }
  return result;
}

Function Stages::finished(std::vector<Output> outputs) {
  result_.outputs = std::move(outputs);
  return std::move(result_);
}

}  // namespace flatdyn
