// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/step_stages.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "graph/passes/substitution.hpp"

namespace flatdyn {

Stages::Stages(const Mechanism& mechanism, Function of)
    : of_(std::move(of)), result_(of_), chart_(mechanism, result_.graph) {
  result_.graph = Graph();
  result_.outputs.clear();
  result_.validity_conditions.clear();
  result_.pivot_scales.clear();
}

std::vector<Stages::Entries> Stages::outputs_at(const StepChart::Positions& positions, const Entries& qd) {
  ++stages_;
  const std::vector<NodeId> image = substituted(
      of_.graph,
      [&](const Input& input, Graph&) -> std::optional<NodeId> {
        const auto k = static_cast<std::size_t>(input.index);
        switch (argument_row(input.kind).in_state) {
          case InputKind::q:
            return positions.q[k];
          case InputKind::qd:
            return qd[k];
          case InputKind::g_b:
            return positions.g_b[k];
          default:
            return std::nullopt;
        }
      },
      graph());
  const auto add_images = [&image](const std::vector<NodeId>& from, std::vector<NodeId>& to) {
    for (const NodeId id : from) to.push_back(image[static_cast<std::size_t>(id)]);
  };
  add_images(of_.validity_conditions, result_.validity_conditions);
  add_images(of_.pivot_scales, result_.pivot_scales);
  std::vector<Entries> outputs;
  for (const Output& output : of_.outputs) add_images(output.entries, outputs.emplace_back());
  return outputs;
}

Stages::Entries Stages::along(const Rational& factor, const Entries& x) {
  const NodeId part = graph().scaled(factor, step_length());
  Entries result;
  for (const NodeId entry : x) result.push_back(graph().product({part, entry}));
  return result;
}

Stages::Entries Stages::rates_after(const Entries& qd, const Rational& factor, const Entries& qdd) {
  Entries result = along(factor, qdd);
  for (std::size_t k = 0; k < qd.size(); ++k) result[k] = graph().sum({{1, qd[k]}, {1, result[k]}});
  name_all("qd", result);
  return result;
}

StepChart::Positions Stages::positions_after(const Entries& change, const StepChart::Turns& turns) {
  StepChart::Positions positions = chart_.after(change, turns);
  name_all("q", positions.q);
  name_all("g_b", positions.g_b);
  return positions;
}

void Stages::name_all(const char* stem, const Entries& entries) {
  for (std::size_t k = 0; k < entries.size(); ++k) {
    graph().set_name(entries[k], fmt::format("{}_stage{}_{}", stem, stages_ + 1, k + 1));
  }
}

Function Stages::finished(std::vector<Output> outputs) {
  result_.outputs = std::move(outputs);
  return std::move(result_);
}

}  // namespace flatdyn
