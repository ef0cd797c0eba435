// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/midpoint.hpp"

#include <fmt/format.h>

#include <optional>
#include <string>

#include "derivation/dynamics/derivative_functions.hpp"
#include "derivation/dynamics/inertia_functions.hpp"
#include "derivation/dynamics/torque_functions.hpp"
#include "graph/passes/substitution.hpp"

namespace flatdyn {
namespace {

// A motion at the middle of the step.
struct MotionOfNodes {
  StepChart::Positions positions;
  StepChart::Entries qd, qdd;
};

void name_all(Graph& graph, const char* stem, const StepChart::Entries& entries) {
  for (std::size_t k = 0; k < entries.size(); ++k) graph.set_name(entries[k], fmt::format("{}_m_{}", stem, k + 1));
}

// Sets the turns of the step, too.
MotionOfNodes motion_in_the_middle(const StepChart& chart, Midpoint& step) {
  Graph& graph = step.function.graph;
  const NodeId rate = graph.quotient(graph.constant(1), step.h);
  MotionOfNodes motion;
  StepChart::Entries change;
  for (std::size_t k = 0; k < step.qd.size(); ++k) {
    motion.qd.push_back(graph.scaled(Rational(1, 2), graph.sum({{1, step.qd[k]}, {1, step.qd_end[k]}})));
    motion.qdd.push_back(graph.product({rate, graph.sum({{1, step.qd_end[k]}, {-1, step.qd[k]}})}));
    change.push_back(graph.product({step.half, motion.qd[k]}));
  }
  step.turns = chart.turns(change, Rational(1, 4));
  motion.positions = chart.after(change, step.turns);
  name_all(graph, "q", motion.positions.q);
  name_all(graph, "g_b", motion.positions.g_b);
  name_all(graph, "qd", motion.qd);
  name_all(graph, "qdd", motion.qdd);
  return motion;
}

// A function's outputs for a motion.
std::vector<Output> outputs_for(const Function& of, const MotionOfNodes& motion, Graph& graph) {
  const auto image_of = [&motion](const Input& input, Graph&) -> std::optional<NodeId> {
    const auto k = static_cast<std::size_t>(input.index);
    switch (argument_row(input.kind).in_state) {
      case InputKind::q:
        return motion.positions.q[k];
      case InputKind::g_b:
        return motion.positions.g_b[k];
      case InputKind::qd:
        return motion.qd[k];
      case InputKind::qdd:
        return motion.qdd[k];
      default:
        return std::nullopt;
    }
  };
  return substituted_outputs(of, image_of, graph);
}

}  // namespace

SquareMatrices::Entries Midpoint::newton_matrix() {
  const SquareMatrices m(function.graph, static_cast<int>(qd.size()));
  return m.sum(inertia, m.scaled(half, m.sum(by_qd, m.scaled(half, by_change))));
}

Midpoint midpoint(const Mechanism& mechanism, const Choices& choices) {
  Midpoint step;
  step.function = derive_inverse_dynamics(mechanism, choices);
  const Function torques = step.function;
  step.function.graph = Graph();
  step.function.outputs.clear();
  Graph& graph = step.function.graph;
  const StepChart chart(mechanism, graph);
  step.qd = chart.arguments(InputKind::qd);
  step.qd_end = chart.arguments(InputKind::qd_end);
  step.h = graph.input({InputKind::h, 0});
  step.half = graph.scaled(Rational(1, 2), step.h);
  const MotionOfNodes motion = motion_in_the_middle(chart, step);
  step.tau = outputs_for(torques, motion, graph).at(0).entries;
  const auto derivatives = outputs_for(derive_inverse_dynamics_derivatives(mechanism, choices), motion, graph);
  const SquareMatrices m(graph, mechanism.size());
  const StepChart::Tangents tangents = chart.tangents_in_the_middle(step.turns);
  const SquareMatrices::Entries& by_position = derivatives.at(0).entries;
  step.by_q = m.product(by_position, tangents.by_position);
  step.by_change = m.product(by_position, m.scaled(graph.constant(2), tangents.by_change));
  step.by_qd = derivatives.at(1).entries;
  step.inertia = outputs_for(derive_inertia_matrix(mechanism, choices), motion, graph).at(0).entries;
  return step;
}

}  // namespace flatdyn
