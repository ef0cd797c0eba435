// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/step_derivative_functions.hpp"

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "derivation/dynamics/acceleration_functions.hpp"
#include "derivation/dynamics/derivative_functions.hpp"
#include "derivation/dynamics/midpoint.hpp"
#include "derivation/dynamics/runge_kutta.hpp"
#include "graph/passes/substitution.hpp"

namespace flatdyn {
namespace {

// The matrix that accelerations divide by; an output is called B here.
constexpr const char* kInertiaMatrix = "the inertia matrix";

// Half of the rows of A and B: those of positions, or of rates.
struct RowsAfterStep {
  SquareMatrices::Entries by_q, by_qd, by_tau;
};

// The chain rule backwards through the stages of the classical Runge-Kutta method, from its last one on. At a stage,
// ∂q̈ = B⁻¹ (∂τ - ∂n) and, with a floating base, what its turning axes add (derive_torque_derivatives_at_solution).
class BackwardChain {
 public:
  using Entries = SquareMatrices::Entries;

  BackwardChain(Stages& stages, const RungeKutta& step)
      : stages_(stages), m_(stages.graph(), static_cast<int>(step.rates.size())), step_(step) {
    const StepChart& chart = stages.chart();
    for (const RungeKutta::Stage& stage : step.stages) {
      positions_.push_back(chart.tangents(stage.change, stage.turns));
      changes_.push_back(chart.tangents_of_rates(stage.change, stage.turns, stage.rates));
    }
  }

  RowsAfterStep rates() {
    RowsAfterStep rows{m_.zero(), unit(), m_.zero()};
    back(m_.zero(), unit(), rows);
    return rows;
  }

  RowsAfterStep positions() {
    const StepChart::Tangents after = stages_.chart().tangents(step_.change, step_.turns);
    RowsAfterStep rows{after.by_position, m_.zero(), m_.zero()};
    back(after.by_change, m_.zero(), rows);
    return rows;
  }

 private:
  Entries unit() const { return m_.diagonal(stages_.graph().constant(1)); }
  // factor h M.
  Entries along(const Rational& factor, const Entries& M) const {
    return m_.scaled(stages_.graph().scaled(factor, stages_.step_length()), M);
  }
  void add(Entries& to, const Entries& more) const { to = m_.sum(to, more); }

  // The result's rows change by those given times the weighted sums of ċ, and of q̈.
  void back(const Entries& by_change, const Entries& by_velocity, RowsAfterStep& rows) {
    Entries by_rates_of_change = m_.zero(), by_accelerations = m_.zero();
    for (std::size_t k = RungeKutta::kStages; k-- > 0;) {
      add(by_rates_of_change, along(RungeKutta::weight(k), by_change));
      add(by_accelerations, along(RungeKutta::weight(k), by_velocity));
      const RungeKutta::Stage& stage = step_.stages[k];
      const StepChart::Tangents& positions = positions_[k];
      const StepChart::RateTangents& changes = changes_[k];
      const Entries by_torques = m_.product(by_accelerations, stage.outputs[3]);
      const auto through_accelerations = [&](const Entries& of_torques, const Entries& of_axes) {
        return m_.sum(m_.product(by_accelerations, of_axes), m_.product(by_torques, of_torques), -1);
      };
      const Entries by_q = through_accelerations(stage.outputs[1], stage.outputs[4]);
      const Entries by_rates = m_.sum(m_.product(by_rates_of_change, changes.by_velocity),
                                      through_accelerations(stage.outputs[2], stage.outputs[5]));
      add(rows.by_tau, by_torques);
      add(rows.by_q, m_.product(by_q, positions.by_position));
      add(rows.by_qd, by_rates);
      if (k == 0) return;
      const Rational part = RungeKutta::part(k);
      const Entries by_c =
          m_.sum(m_.product(by_q, positions.by_change), m_.product(by_rates_of_change, changes.by_change));
      by_rates_of_change = along(part, by_c);
      by_accelerations = along(part, by_rates);
    }
  }

  Stages& stages_;
  SquareMatrices m_;
  const RungeKutta& step_;
  std::vector<StepChart::Tangents> positions_;    // by stage
  std::vector<StepChart::RateTangents> changes_;  // by stage
};

// A and B from their halves.
std::vector<Output> derivative_outputs(const StepChart& chart, const RowsAfterStep& positions,
                                       const RowsAfterStep& rates) {
  const int n = chart.size();
  std::vector<NodeId> by_state, by_torque;
  for (const RowsAfterStep* rows : {&positions, &rates}) {
    for (int i = 0; i < n; ++i) {
      const auto append_row = [i, n](const SquareMatrices::Entries& from, std::vector<NodeId>& to) {
        to.insert(to.end(), from.begin() + i * n, from.begin() + (i + 1) * n);
      };
      append_row(rows->by_q, by_state);
      append_row(rows->by_qd, by_state);
      append_row(rows->by_tau, by_torque);
    }
  }
  const std::string turns =
      !chart.has_turns() ? ""
      : chart.has_base() ? "; the first entries of both are p + R d and R exp(S(d)) of the base, in its axes there"
                         : "; for a spherical joint, of turns R exp(S(d)) of the child, in its axes there";
  return {
      matrix_output("A", 2 * n, 2 * n, by_state,
                    "row i, column k: of entry i of (q_next, qd_next) by entry k of (q, qd)" + turns),
      matrix_output("B", 2 * n, n, by_torque, "row i, column k: of entry i of (q_next, qd_next) by tau[k]" + turns)};
}

// Rows of positions from those of rates, where w = factor (q̇' or q̇ + q̇') and `sum` are the derivatives of the latter.
RowsAfterStep rows_of_positions(const SquareMatrices& m, const StepChart::Tangents& tangents, NodeId factor,
                                const RowsAfterStep& sum) {
  const auto along = [&](const SquareMatrices::Entries& by) {
    return m.product(tangents.by_change, m.scaled(factor, by));
  };
  return {m.sum(tangents.by_position, along(sum.by_q)), along(sum.by_qd), along(sum.by_tau)};
}

// h q̇' with q̈ from a function, for the robots that need it.
StepChart::Entries change_of_positions(const StepChart& chart, const Function& forward, Graph& graph) {
  const NodeId h = graph.input({InputKind::h, 0});
  const auto same = [](const Input&, Graph&) { return std::nullopt; };
  const std::vector<NodeId> qdd = substituted_outputs(forward, same, graph).at(0).entries;
  StepChart::Entries change = chart.arguments(InputKind::qd);
  for (std::size_t k = 0; k < change.size(); ++k) {
    change[k] = graph.product({h, graph.sum({{1, change[k]}, {1, graph.product({h, qdd[k]})}})});
  }
  return change;
}

// The derivatives from those of the accelerations by q, q̇ and τ, the outputs of a function.
Function semi_implicit_derivatives(const Mechanism& mechanism, const Choices& choices, Function function) {
  Graph& graph = function.graph;
  const StepChart chart(mechanism, graph);
  const SquareMatrices m(graph, mechanism.size());
  const NodeId h = graph.input({InputKind::h, 0});
  StepChart::Entries change;  // joints of one axis need none
  if (chart.has_turns()) change = change_of_positions(chart, derive_forward_dynamics(mechanism, choices), graph);
  const std::vector<Output>& of = function.outputs;
  const RowsAfterStep rates{m.scaled(h, of[0].entries),
                            m.sum(m.diagonal(graph.constant(1)), m.scaled(h, of[1].entries)),
                            m.scaled(h, of[2].entries)};
  const StepChart::Tangents tangents = chart.tangents_along(change, chart.turns(change, Rational(1, 8)));
  function.outputs = derivative_outputs(chart, rows_of_positions(m, tangents, h, rates), rates);
  function.inverted = kInertiaMatrix;
  return function;
}

// The derivatives from q̈, those of the torques at it, and B⁻¹, the outputs of a function.
Function runge_kutta_derivatives(const Mechanism& mechanism, Function at_solution) {
  Stages stages(mechanism, std::move(at_solution));
  const RungeKutta step = runge_kutta(stages);
  BackwardChain chain(stages, step);
  const RowsAfterStep positions = chain.positions(), rates = chain.rates();
  Function function = stages.finished(derivative_outputs(stages.chart(), positions, rates));
  function.inverted = kInertiaMatrix;
  return function;
}

// K ∂q̇' = -h ∂τ/∂q ∂q + (B - h/2 ∂τ/∂q̇ - h²/4 ∂τ/∂q) ∂q̇ + h ∂τ with K from the midpoint.
Function midpoint_derivatives(const Mechanism& mechanism, Midpoint step) {
  Graph& graph = step.function.graph;
  const StepChart chart(mechanism, graph);
  const SquareMatrices m(graph, mechanism.size());
  const int n = m.size();
  const SquareMatrices::Entries one = m.diagonal(graph.constant(1));
  const SquareMatrices::Entries velocity_terms =
      m.scaled(step.half, m.sum(step.by_qd, m.scaled(step.half, step.by_change)));
  const std::array<SquareMatrices::Entries, 3> changes = {m.sum(m.zero(), m.scaled(step.h, step.by_q), -1),
                                                          m.sum(step.inertia, velocity_terms, -1), m.diagonal(step.h)};
  SquareMatrices::Entries right;
  for (int i = 0; i < n; ++i) {
    for (const SquareMatrices::Entries& change : changes) {
      right.insert(right.end(), change.begin() + i * n, change.begin() + (i + 1) * n);
    }
  }
  const SquareMatrices::Solution solved = m.solution(step.newton_matrix(), right, 3 * n);
  RowsAfterStep rates;
  for (int i = 0; i < n; ++i) {
    auto from = solved.x.begin() + i * 3 * n;
    for (SquareMatrices::Entries* block : {&rates.by_q, &rates.by_qd, &rates.by_tau}) {
      block->insert(block->end(), from, from + n);
      from += n;
    }
  }
  StepChart::Entries w;
  for (std::size_t k = 0; k < step.qd.size(); ++k) {
    w.push_back(graph.product({step.half, graph.sum({{1, step.qd[k]}, {1, step.qd_end[k]}})}));
  }
  const RowsAfterStep both{rates.by_q, m.sum(one, rates.by_qd), rates.by_tau};
  step.function.validity_conditions = solved.pivots;
  step.function.inverted = kNewtonMatrix;
  step.function.outputs =
      derivative_outputs(chart, rows_of_positions(m, chart.tangents_along(w, step.turns), step.half, both), rates);
  return std::move(step.function);
}

}  // namespace

Function derive_semi_implicit_step_derivatives(const Mechanism& mechanism, const Choices& choices) {
  return semi_implicit_derivatives(mechanism, choices, derive_forward_dynamics_derivatives(mechanism, choices));
}

std::optional<Function> derive_semi_implicit_step_derivatives_by_products(const Mechanism& mechanism,
                                                                          const Choices& choices) {
  return semi_implicit_derivatives(mechanism, choices,
                                   *derive_forward_dynamics_derivatives_by_products(mechanism, choices));
}

Function derive_runge_kutta_step_derivatives(const Mechanism& mechanism, const Choices& choices) {
  return runge_kutta_derivatives(mechanism, derive_torque_derivatives_at_solution(mechanism, choices));
}

Function derive_midpoint_step_derivatives(const Mechanism& mechanism, const Choices& choices) {
  return midpoint_derivatives(mechanism, midpoint(mechanism, choices));
}

}  // namespace flatdyn
