// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/step_derivative_functions.hpp"

#include <array>
#include <utility>
#include <vector>

#include "derivation/dynamics/derivative_functions.hpp"
#include "derivation/dynamics/midpoint.hpp"
#include "derivation/dynamics/square_matrices.hpp"
#include "derivation/dynamics/step_stages.hpp"

namespace flatdyn {
namespace {

// The matrix that accelerations divide by; an output is called B here.
constexpr const char* kInertiaMatrix = "the inertia matrix";

// A stage: the derivatives of the torques at its q̈, and B⁻¹.
struct TorquesAtStage {
  SquareMatrices::Entries by_q, by_qd, inverse;
};

// The derivatives of rows of the state after the step: by the q, q̇ and τ of a stage, through its q̈ alone.
struct ThroughStage {
  SquareMatrices::Entries q, qd, tau;
};

// M ∂q̈/∂(q, q̇, τ) with q̈ = B⁻¹ (τ - n): M B⁻¹ is made first.
ThroughStage through(const SquareMatrices& m, const SquareMatrices::Entries& M, const TorquesAtStage& stage) {
  const SquareMatrices::Entries W = m.product(M, stage.inverse), none = m.zero();
  return {m.sum(none, m.product(W, stage.by_q), -1), m.sum(none, m.product(W, stage.by_qd), -1), W};
}

// The same for M = factor times the identity. `of_unit`: for the identity.
ThroughStage scaled(const SquareMatrices& m, NodeId factor, const ThroughStage& of_unit) {
  return {m.scaled(factor, of_unit.q), m.scaled(factor, of_unit.qd), m.scaled(factor, of_unit.tau)};
}

// Half of the rows of A and B: those of positions, or of rates.
struct RowsAfterStep {
  SquareMatrices::Entries by_q, by_qd, by_tau;
};

// The chain rule of the classical Runge-Kutta method, backwards from x' = x_0 + Σ f_k q̈_k through
//   q_4 = q + h q̇_3,  q̇_4 = q̇ + h q̈_3,  and  q_k = q + h/2 q̇_{k-1},  q̇_k = q̇ + h/2 q̈_{k-1}  for k = 2, 3.
class BackwardChain {
 public:
  BackwardChain(Stages& stages, const std::array<TorquesAtStage, 4>& at, int size)
      : graph_(stages.graph()),
        m_(graph_, size),
        at_(at),
        h_(stages.step_length()),
        half_(graph_.scaled(Rational(1, 2), h_)),
        third_(graph_.scaled(Rational(1, 3), h_)),
        sixth_(graph_.scaled(Rational(1, 6), h_)) {}

  // The rows of q̇' = q̇ + h/6 (q̈_1 + 2 q̈_2 + 2 q̈_3 + q̈_4).
  RowsAfterStep rates() const {
    const ThroughStage last = scaled(m_, sixth_, through_unit(3));
    RowsAfterStep rows{last.q, m_.sum(m_.diagonal(graph_.constant(1)), last.qd), last.tau};
    const SquareMatrices::Entries by_third = m_.sum(m_.diagonal(third_), m_.scaled(h_, last.qd));
    back({sixth_, third_, third_}, through(m_, by_third, at_[2]), m_.scaled(h_, last.q), rows);
    return rows;
  }

  // The rows of q' = q + h q̇ + h²/6 (q̈_1 + q̈_2 + q̈_3).
  RowsAfterStep positions() const {
    const NodeId factor = graph_.product({h_, sixth_});
    RowsAfterStep rows{m_.diagonal(graph_.constant(1)), m_.diagonal(h_), m_.zero()};
    back({factor, factor, factor}, scaled(m_, factor, through_unit(2)), m_.zero(), rows);
    return rows;
  }

 private:
  ThroughStage through_unit(std::size_t stage) const {
    return through(m_, m_.diagonal(graph_.constant(1)), at_[stage]);
  }

  void add(SquareMatrices::Entries& to, const SquareMatrices::Entries& more) const { to = m_.sum(to, more); }

  // From the third stage to the first one. `f`: f_1, f_2, f_3 from the first stage on, of which f_3 is in `at` already;
  // `by_rate`: the derivatives by q̇_3 apart from those through q̈_3.
  void back(const std::array<NodeId, 3>& f, ThroughStage at, SquareMatrices::Entries by_rate,
            RowsAfterStep& rows) const {
    for (std::size_t k = 2;; --k) {
      add(rows.by_q, at.q);
      add(rows.by_tau, at.tau);
      add(by_rate, at.qd);
      add(rows.by_qd, by_rate);
      if (k == 0) return;
      const SquareMatrices::Entries by_acceleration = m_.sum(m_.diagonal(f[k - 1]), m_.scaled(half_, by_rate));
      by_rate = m_.scaled(half_, at.q);
      at = through(m_, by_acceleration, at_[k - 1]);
    }
  }

  Graph& graph_;
  SquareMatrices m_;
  const std::array<TorquesAtStage, 4>& at_;
  NodeId h_, half_, third_, sixth_;
};

// A and B from their halves.
std::vector<Output> derivative_outputs(int n, const RowsAfterStep& positions, const RowsAfterStep& rates) {
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
  return {matrix_output("A", 2 * n, 2 * n, by_state,
                        "row i, column k: of entry i of (q_next, qd_next) by entry k of (q, qd)"),
          matrix_output("B", 2 * n, n, by_torque, "row i, column k: of entry i of (q_next, qd_next) by tau[k]")};
}

// The derivatives from those of the accelerations by q, q̇ and τ, the outputs of a function.
Function semi_implicit_derivatives(Function function) {
  Graph& graph = function.graph;
  const std::vector<Output> of = function.outputs;
  const SquareMatrices m(graph, of.at(0).rows);
  const NodeId h = graph.input({InputKind::h, 0});
  const SquareMatrices::Entries one = m.diagonal(graph.constant(1));
  const RowsAfterStep rates{m.scaled(h, of[0].entries), m.sum(one, m.scaled(h, of[1].entries)),
                            m.scaled(h, of[2].entries)};
  const RowsAfterStep positions{m.sum(one, m.scaled(h, rates.by_q)), m.scaled(h, rates.by_qd),
                                m.scaled(h, rates.by_tau)};
  function.outputs = derivative_outputs(m.size(), positions, rates);
  function.inverted = kInertiaMatrix;
  return function;
}

// The derivatives from q̈, those of the torques at it, and B⁻¹, the outputs of a function.
Function runge_kutta_derivatives(Function at_solution) {
  const int n = at_solution.outputs.at(0).rows;
  Stages stages(std::move(at_solution));
  const std::vector<NodeId> q = stages.arguments(InputKind::q), qd = stages.arguments(InputKind::qd);
  std::array<TorquesAtStage, 4> at;
  std::vector<NodeId> position = q, rate = qd;
  for (std::size_t k = 0; k < at.size(); ++k) {
    auto outputs = stages.outputs_at(position, rate);
    at[k] = {std::move(outputs[1]), std::move(outputs[2]), std::move(outputs[3])};
    const Rational part = k + 2 < at.size() ? Rational(1, 2) : Rational(1);
    position = stages.after("q", q, part, rate);
    rate = stages.after("qd", qd, part, outputs[0]);
  }
  const BackwardChain chain(stages, at, n);
  const RowsAfterStep positions = chain.positions(), rates = chain.rates();
  Function function = stages.finished(derivative_outputs(n, positions, rates));
  function.inverted = kInertiaMatrix;
  return function;
}

// K ∂q̇' = -h ∂τ/∂q ∂q + (B - h/2 ∂τ/∂q̇ - h²/4 ∂τ/∂q) ∂q̇ + h ∂τ with K from the midpoint.
Function midpoint_derivatives(Midpoint step) {
  Graph& graph = step.function.graph;
  const SquareMatrices m(graph, static_cast<int>(step.q.size()));
  const int n = m.size();
  const SquareMatrices::Entries one = m.diagonal(graph.constant(1));
  const SquareMatrices::Entries velocity_terms = m.scaled(step.half, m.sum(step.by_qd, m.scaled(step.half, step.by_q)));
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
  const RowsAfterStep positions{m.sum(one, m.scaled(step.half, rates.by_q)),
                                m.scaled(step.half, m.sum(one, rates.by_qd)), m.scaled(step.half, rates.by_tau)};
  step.function.validity_conditions = solved.pivots;
  step.function.inverted = kNewtonMatrix;
  step.function.outputs = derivative_outputs(n, positions, rates);
  return std::move(step.function);
}

}  // namespace

Function derive_semi_implicit_step_derivatives(const Mechanism& mechanism, const Choices& choices) {
  return semi_implicit_derivatives(derive_forward_dynamics_derivatives(mechanism, choices));
}

std::optional<Function> derive_semi_implicit_step_derivatives_by_products(const Mechanism& mechanism,
                                                                          const Choices& choices) {
  return semi_implicit_derivatives(*derive_forward_dynamics_derivatives_by_products(mechanism, choices));
}

Function derive_runge_kutta_step_derivatives(const Mechanism& mechanism, const Choices& choices) {
  return runge_kutta_derivatives(derive_torque_derivatives_at_solution(mechanism, choices));
}

Function derive_midpoint_step_derivatives(const Mechanism& mechanism, const Choices& choices) {
  return midpoint_derivatives(midpoint(mechanism, choices));
}

}  // namespace flatdyn
