// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/step_functions.hpp"

#include <string>
#include <utility>
#include <vector>

#include "derivation/dynamics/acceleration_functions.hpp"
#include "derivation/dynamics/midpoint.hpp"
#include "derivation/dynamics/runge_kutta.hpp"

namespace flatdyn {
namespace {

// The positions after a change, and the velocities there.
std::vector<Output> state_outputs(const StepChart& chart, const StepChart::Entries& change,
                                  const StepChart::Turns& turns, const StepChart::Entries& rates) {
  std::vector<Output> outputs;
  const StepChart::Positions positions = chart.after(change, turns);
  if (!positions.q.empty()) {
    const std::string of_quaternions = chart.has_quaternions() ? "; unit quaternions as in q" : "";
    outputs.push_back(
        vector_output("q_next", positions.q, "joint positions after the step, rad or m" + of_quaternions));
  }
  outputs.push_back(vector_output("qd_next", rates,
                                  chart.has_turns() ? "velocities after the step, with entries as those of v"
                                                    : "joint velocities after the step, rad/s or m/s"));
  if (!chart.has_base()) return outputs;
  const StepChart::Quaternion& E = turns.front();
  outputs.push_back(vector_output("displacement", {change.begin(), change.begin() + 3},
                                  "of the base during the step, in base axes before it, m"));
  outputs.push_back(vector_output("turn", {E.begin(), E.end()},
                                  "unit quaternion w, x, y, z from base axes after the step to those before it"));
  return outputs;
}

// The same after two turns for w = h (v, ω, ...), with the base's displacement along its axes in the middle.
std::vector<Output> state_outputs_along(const StepChart& chart, const StepChart::Entries& w,
                                        const StepChart::Entries& rates) {
  const StepChart::Turns turns = chart.turns(w, Rational(1, 8));
  return state_outputs(chart, chart.with_base_turned(turns, w), chart.twice(turns), rates);
}

// q̇' and q' from the accelerations, the first output.
Function semi_implicit_euler(const Mechanism& mechanism, Function function) {
  Graph& graph = function.graph;
  const StepChart chart(mechanism, graph);
  const NodeId h = graph.input({InputKind::h, 0});
  StepChart::Entries rates = chart.arguments(InputKind::qd), change;
  const std::vector<NodeId>& accelerations = function.outputs.at(0).entries;
  for (std::size_t k = 0; k < rates.size(); ++k) {
    rates[k] = graph.sum({{1, rates[k]}, {1, graph.product({h, accelerations[k]})}});
    change.push_back(graph.product({h, rates[k]}));
  }
  function.outputs = state_outputs_along(chart, change, rates);
  return function;
}

Function runge_kutta_4(const Mechanism& mechanism, Function forward) {
  Stages stages(mechanism, std::move(forward));
  const RungeKutta step = runge_kutta(stages);
  return stages.finished(state_outputs(stages.chart(), step.change, step.turns, step.rates));
}

// K x = r with K from the midpoint, so that q̇' is qd_end - h x.
Function newton_iteration(const Mechanism& mechanism, Midpoint step) {
  Graph& graph = step.function.graph;
  const StepChart chart(mechanism, graph);
  const SquareMatrices m(graph, mechanism.size());
  const StepChart::Entries torques = chart.arguments(InputKind::tau);
  StepChart::Entries residual, change, rates;
  for (std::size_t k = 0; k < torques.size(); ++k) {
    residual.push_back(graph.sum({{1, step.tau[k]}, {-1, torques[k]}}));
  }
  const SquareMatrices::Solution solved = m.solution(step.newton_matrix(), residual, 1);
  for (std::size_t k = 0; k < torques.size(); ++k) {
    rates.push_back(graph.sum({{1, step.qd_end[k]}, {-1, graph.product({step.h, solved.x[k]})}}));
    change.push_back(graph.product({step.half, graph.sum({{1, step.qd[k]}, {1, rates[k]}})}));
  }
  step.function.validity_conditions = solved.pivots;
  step.function.inverted = kNewtonMatrix;
  step.function.outputs = state_outputs_along(chart, change, rates);
  step.function.outputs.push_back(
      vector_output("residual", residual, "torques that qd_end needs, less tau, N m or N: small if qd_end was right"));
  return std::move(step.function);
}

using Method = Function(const Mechanism& mechanism, Function forward);

template <Method method>
Function step_by(const Mechanism& mechanism, const Choices& choices) {
  return method(mechanism, derive_forward_dynamics(mechanism, choices));
}

template <Method method>
std::optional<Function> step_by(const Mechanism& mechanism, std::optional<Function> forward) {
  if (!forward) return std::nullopt;
  return method(mechanism, std::move(*forward));
}

template <Method method>
std::optional<Function> step_by_articulated_bodies(const Mechanism& mechanism, const Choices& choices) {
  return step_by<method>(mechanism, derive_forward_dynamics_by_articulated_bodies(mechanism, choices));
}

template <Method method>
std::optional<Function> step_by_composite_bodies(const Mechanism& mechanism, const Choices& choices) {
  return step_by<method>(mechanism, derive_forward_dynamics_by_composite_bodies(mechanism, choices));
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
  return newton_iteration(mechanism, midpoint(mechanism, choices));
}

}  // namespace flatdyn
