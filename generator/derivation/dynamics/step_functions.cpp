// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/step_functions.hpp"

#include <utility>
#include <vector>

#include "derivation/dynamics/acceleration_functions.hpp"
#include "derivation/dynamics/midpoint.hpp"
#include "derivation/dynamics/step_stages.hpp"

namespace flatdyn {
namespace {

std::vector<Output> state_outputs(const std::vector<NodeId>& positions, const std::vector<NodeId>& rates) {
  return {vector_output("q_next", positions, "joint positions after the step, rad or m"),
          vector_output("qd_next", rates, "joint velocities after the step, rad/s or m/s")};
}

// q̇' and q' from the accelerations, the first output.
Function semi_implicit_euler(Function function) {
  Graph& graph = function.graph;
  const NodeId h = graph.input({InputKind::h, 0});
  std::vector<NodeId> positions, rates;
  for (const NodeId qdd : function.outputs.at(0).entries) {
    const int k = static_cast<int>(rates.size());
    rates.push_back(graph.sum({{1, graph.input({InputKind::qd, k})}, {1, graph.product({h, qdd})}}));
    positions.push_back(graph.sum({{1, graph.input({InputKind::q, k})}, {1, graph.product({h, rates.back()})}}));
  }
  function.outputs = state_outputs(positions, rates);
  return function;
}

// The classical method of fourth order (Hairer, Nørsett, Wanner: Solving Ordinary Differential Equations I, II.1),
// where q' = q + h (q̇ + 2 q̇_2 + 2 q̇_3 + q̇_4) / 6 is q + h q̇ + h² (q̈_1 + q̈_2 + q̈_3) / 6.
Function runge_kutta_4(Function forward) {
  Stages stages(std::move(forward));
  const auto accelerations = [&stages](const std::vector<NodeId>& q, const std::vector<NodeId>& qd) {
    return stages.outputs_at(q, qd).at(0);
  };
  const Rational half(1, 2), sixth(1, 6);
  const std::vector<NodeId> q = stages.arguments(InputKind::q), qd = stages.arguments(InputKind::qd);
  const std::vector<NodeId> qdd_1 = accelerations(q, qd);
  const std::vector<NodeId> qd_2 = stages.after("qd", qd, half, qdd_1);
  const std::vector<NodeId> qdd_2 = accelerations(stages.after("q", q, half, qd), qd_2);
  const std::vector<NodeId> qd_3 = stages.after("qd", qd, half, qdd_2);
  const std::vector<NodeId> qdd_3 = accelerations(stages.after("q", q, half, qd_2), qd_3);
  const std::vector<NodeId> qd_4 = stages.after("qd", qd, 1, qdd_3);
  const std::vector<NodeId> qdd_4 = accelerations(stages.after("q", q, 1, qd_3), qd_4);
  Graph& graph = stages.graph();
  const NodeId h = stages.step_length(), h_6 = graph.scaled(sixth, h);
  std::vector<NodeId> positions, rates;
  for (std::size_t k = 0; k < q.size(); ++k) {
    const NodeId first_three = graph.sum({{1, qdd_1[k]}, {1, qdd_2[k]}, {1, qdd_3[k]}});
    const NodeId all = graph.sum({{1, first_three}, {1, qdd_2[k]}, {1, qdd_3[k]}, {1, qdd_4[k]}});
    const NodeId mean_rate = graph.sum({{1, qd[k]}, {1, graph.product({h_6, first_three})}});
    positions.push_back(graph.sum({{1, q[k]}, {1, graph.product({h, mean_rate})}}));
    rates.push_back(graph.sum({{1, qd[k]}, {1, graph.product({h_6, all})}}));
  }
  return stages.finished(state_outputs(positions, rates));
}

// K x = r with K from the midpoint, so that q̇' is qd_end - h x.
Function newton_iteration(Midpoint step) {
  Graph& graph = step.function.graph;
  const SquareMatrices m(graph, static_cast<int>(step.q.size()));
  std::vector<NodeId> residual, positions, rates;
  for (std::size_t k = 0; k < step.q.size(); ++k) {
    const NodeId tau = graph.input({InputKind::tau, static_cast<int>(k)});
    residual.push_back(graph.sum({{1, step.tau[k]}, {-1, tau}}));
  }
  const SquareMatrices::Solution solved = m.solution(step.newton_matrix(), residual, 1);
  for (std::size_t k = 0; k < step.q.size(); ++k) {
    rates.push_back(graph.sum({{1, step.qd_end[k]}, {-1, graph.product({step.h, solved.x[k]})}}));
    const NodeId both = graph.sum({{1, step.qd[k]}, {1, rates[k]}});
    positions.push_back(graph.sum({{1, step.q[k]}, {1, graph.product({step.half, both})}}));
  }
  step.function.validity_conditions = solved.pivots;
  step.function.inverted = kNewtonMatrix;
  step.function.outputs = state_outputs(positions, rates);
  step.function.outputs.push_back(
      vector_output("residual", residual, "torques that qd_end needs, less tau, N m or N: small if qd_end was right"));
  return std::move(step.function);
}

using Method = Function(Function forward);

template <Method method>
Function step_by(const Mechanism& mechanism, const Choices& choices) {
  return method(derive_forward_dynamics(mechanism, choices));
}

template <Method method>
std::optional<Function> step_by(std::optional<Function> forward) {
  if (!forward) return std::nullopt;
  return method(std::move(*forward));
}

template <Method method>
std::optional<Function> step_by_articulated_bodies(const Mechanism& mechanism, const Choices& choices) {
  return step_by<method>(derive_forward_dynamics_by_articulated_bodies(mechanism, choices));
}

template <Method method>
std::optional<Function> step_by_composite_bodies(const Mechanism& mechanism, const Choices& choices) {
  return step_by<method>(derive_forward_dynamics_by_composite_bodies(mechanism, choices));
}

}  // namespace

Function derive_semi_implicit_step(const Mechanism& mechanism, const Choices& choices) {
  return step_by<semi_implicit_euler>(mechanism, choices);
}
std::optional<Function> derive_semi_implicit_step_by_articulated_bodies(const Mechanism& mechanism,
                                                                        const Choices& choices) {
  return step_by_articulated_bodies<semi_implicit_euler>(mechanism, choices);
}
std::optional<Function> derive_semi_implicit_step_by_composite_bodies(const Mechanism& mechanism,
                                                                      const Choices& choices) {
  return step_by_composite_bodies<semi_implicit_euler>(mechanism, choices);
}

Function derive_runge_kutta_step(const Mechanism& mechanism, const Choices& choices) {
  return step_by<runge_kutta_4>(mechanism, choices);
}
std::optional<Function> derive_runge_kutta_step_by_articulated_bodies(const Mechanism& mechanism,
                                                                      const Choices& choices) {
  return step_by_articulated_bodies<runge_kutta_4>(mechanism, choices);
}
std::optional<Function> derive_runge_kutta_step_by_composite_bodies(const Mechanism& mechanism,
                                                                    const Choices& choices) {
  return step_by_composite_bodies<runge_kutta_4>(mechanism, choices);
}

Function derive_midpoint_step(const Mechanism& mechanism, const Choices& choices) {
  return newton_iteration(midpoint(mechanism, choices));
}

}  // namespace flatdyn
