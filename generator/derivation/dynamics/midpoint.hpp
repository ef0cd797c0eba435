// SPDX-License-Identifier: GPL-2.0-or-later
// The implicit midpoint rule: from q, q̇ over a step of length h to q', q̇' with
//   q' = q + h q̇_m,  q̇_m = (q̇ + q̇') / 2,  τ = B(q_m) (q̇' - q̇) / h + n(q_m, q̇_m),  q_m = q + h/2 q̇_m.
// A floating base and spherical joints turn by E(h ω_m/8) to q_m (step_chart.hpp), and once more to q'; the base is
// displaced by h v_m in its axes at q_m. So the rule is symmetric there, too, and of order 2.
#pragma once

#include <vector>

#include "derivation/dynamics/derivation_context.hpp"
#include "derivation/dynamics/step_chart.hpp"

namespace flatdyn {

// The matrix of Newton's method, in words.
inline constexpr const char* kNewtonMatrix = "the inertia matrix + h/2 dtau_dqd + h^2/4 dtau_dq";

// The torques for q̇' = qd_end at the middle of a step, and how they change, as nodes of a function without outputs.
struct Midpoint {
  Function function;
  StepChart::Entries qd, qd_end;
  NodeId h = 0, half = 0;  // h and h/2
  StepChart::Entries tau;
  StepChart::Turns turns;  // from q to q_m
  // At q_m, q̇_m and q̈_m = (q̇' - q̇) / h: ∂τ/∂q, by a turn before the step and by h/2 q̇_m; ∂τ/∂q̇; B.
  SquareMatrices::Entries by_q, by_change, by_qd, inertia;

  // h ∂τ/∂q̇' = B + h/2 ∂τ/∂q̇ + h²/4 ∂τ/∂q.
  SquareMatrices::Entries newton_matrix();
};

Midpoint midpoint(const Mechanism& mechanism, const Choices& choices);

}  // namespace flatdyn
