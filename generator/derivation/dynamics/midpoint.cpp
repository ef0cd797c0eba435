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
  std::vector<NodeId> q, qd, qdd;
};

MotionOfNodes motion_in_the_middle(Midpoint& step) {
  Graph& graph = step.function.graph;
  const Rational half(1, 2);
  const NodeId rate = graph.quotient(graph.constant(1), step.h);
  MotionOfNodes motion;
  for (std::size_t k = 0; k < step.q.size(); ++k) {
    motion.qd.push_back(graph.scaled(half, graph.sum({{1, step.qd[k]}, {1, step.qd_end[k]}})));
    motion.q.push_back(graph.sum({{1, step.q[k]}, {1, graph.product({step.half, motion.qd[k]})}}));
    motion.qdd.push_back(graph.product({rate, graph.sum({{1, step.qd_end[k]}, {-1, step.qd[k]}})}));
    const auto name = [&graph, k](NodeId id, const char* stem) {
      graph.set_name(id, fmt::format("{}_m_{}", stem, k + 1));
    };
    name(motion.q[k], "q");
    name(motion.qd[k], "qd");
    name(motion.qdd[k], "qdd");
  }
  return motion;
}

// A function's outputs for a motion.
std::vector<Output> outputs_for(const Function& of, const MotionOfNodes& motion, Graph& graph) {
  const auto image_of = [&motion](const Input& input, Graph&) -> std::optional<NodeId> {
    const auto k = static_cast<std::size_t>(input.index);
    if (input.kind == InputKind::q) return motion.q[k];
    if (input.kind == InputKind::qd) return motion.qd[k];
    if (input.kind == InputKind::qdd) return motion.qdd[k];
    return std::nullopt;
  };
  return substituted_outputs(of, image_of, graph);
}

}  // namespace

SquareMatrices::Entries Midpoint::newton_matrix() {
  const SquareMatrices m(function.graph, static_cast<int>(q.size()));
  return m.sum(inertia, m.scaled(half, m.sum(by_qd, m.scaled(half, by_q))));
}

Midpoint midpoint(const Mechanism& mechanism, const Choices& choices) {
  const Function torques = derive_inverse_dynamics(mechanism, choices);
  Midpoint step{torques, {}, {}, {}, 0, 0, {}, {}, {}, {}};
  step.function.graph = Graph();
  step.function.outputs.clear();
  Graph& graph = step.function.graph;
  for (int k = 0; k < mechanism.size(); ++k) {
    step.q.push_back(graph.input({InputKind::q, k}));
    step.qd.push_back(graph.input({InputKind::qd, k}));
    step.qd_end.push_back(graph.input({InputKind::qd_end, k}));
  }
  step.h = graph.input({InputKind::h, 0});
  step.half = graph.scaled(Rational(1, 2), step.h);
  const MotionOfNodes motion = motion_in_the_middle(step);
  step.tau = outputs_for(torques, motion, graph).at(0).entries;
  const auto derivatives = outputs_for(derive_inverse_dynamics_derivatives(mechanism, choices), motion, graph);
  step.by_q = derivatives.at(0).entries;
  step.by_qd = derivatives.at(1).entries;
  step.inertia = outputs_for(derive_inertia_matrix(mechanism, choices), motion, graph).at(0).entries;
  return step;
}

}  // namespace flatdyn
