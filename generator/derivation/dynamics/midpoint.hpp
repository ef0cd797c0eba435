// SPDX-License-Identifier: GPL-2.0-or-later
// The implicit midpoint rule: from q, q̇ over a step of length h to q', q̇' with
//   q' = q + h q̇_m,  q̇_m = (q̇ + q̇') / 2,  τ = B(q_m) (q̇' - q̇) / h + n(q_m, q̇_m),  q_m = q + h/2 q̇_m.
#pragma once

#include <vector>

#include "derivation/dynamics/derivation_context.hpp"
#include "derivation/dynamics/square_matrices.hpp"

namespace flatdyn {

// The matrix of Newton's method, in words.
inline constexpr const char* kNewtonMatrix = "the inertia matrix + h/2 dtau_dqd + h^2/4 dtau_dq";

// The torques for q̇' = qd_end at the middle of a step, and how they change, as nodes of a function without outputs.
struct Midpoint {
  Function function;
  std::vector<NodeId> q, qd, qd_end;
  NodeId h = 0, half = 0;  // h and h/2
  std::vector<NodeId> tau;
  SquareMatrices::Entries by_q, by_qd, inertia;  // ∂τ/∂q and ∂τ/∂q̇ at q_m, q̇_m and q̈_m = (q̇' - q̇) / h; B(q_m)

  // h ∂τ/∂q̇' = B + h/2 ∂τ/∂q̇ + h²/4 ∂τ/∂q.
  SquareMatrices::Entries newton_matrix();
};

Midpoint midpoint(const Mechanism& mechanism, const Choices& choices);

}  // namespace flatdyn
