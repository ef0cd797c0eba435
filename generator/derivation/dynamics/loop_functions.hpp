// SPDX-License-Identifier: GPL-2.0-or-later
// The functions that a user needs to close loops: positions, rates and accelerations of all joints.
#pragma once

#include <vector>

#include "derivation/dynamics/derivation_context.hpp"
#include "derivation/loops/loops.hpp"

namespace flatdyn {

// All of these throw Failure(unsupported) for a robot without closed loops.
Function derive_loop_closure(const Mechanism& mechanism);   // Φ(q)
Function derive_loop_jacobian(const Mechanism& mechanism);  // Φ_q
Function derive_loop_step(const Mechanism& mechanism);      // Newton's step towards Φ = 0
Function derive_loop_motion(const Mechanism& mechanism);    // q̇ and q̈ of all joints

// G, m × n, row by row, and the conditions of its loops, as nodes of a graph.
struct LoopRates {
  Graph graph;
  std::vector<NodeId> G;
  std::vector<ClosedLoops::Condition> conditions;
};
LoopRates derive_loop_rates(const Mechanism& mechanism, const Choices& choices);

// Lets a function require that a loop is not singular, unless it does so already: `value` as in
// Function::validity_conditions, `scale` as in Function::pivot_scales.
void require_loop(Function& function, NodeId value, NodeId scale);

}  // namespace flatdyn
