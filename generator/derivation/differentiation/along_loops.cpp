// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/differentiation/along_loops.hpp"

#include <utility>

#include "derivation/differentiation/at_solution.hpp"
#include "derivation/differentiation/differentiable.hpp"
#include "derivation/differentiation/differentiate.hpp"
#include "derivation/dynamics/derivative_functions.hpp"
#include "derivation/dynamics/square_matrices.hpp"
#include "derivation/dynamics/torque_functions.hpp"

namespace flatdyn {
namespace {

// The derivatives of inverse dynamics by q and by velocities.
Function torque_derivatives_along_loops(const Mechanism& mechanism, const Choices& choices) {
  const InputKind velocity = with_base(InputKind::qd, mechanism.has_quasi_velocities());
  const Differentiable torques(mechanism, derive_inverse_dynamics(mechanism, choices), {InputKind::q, velocity},
                               choices);
  Function result = torques.finished(jacobian_matrices(torques.function(), torques.tangents()));
  const int n = mechanism.size();
  const std::vector<NodeId> by_q = result.outputs[0].entries, by_velocity = result.outputs[1].entries;
  result.outputs = {matrix_output("dtau_dq", n, n, by_q, "row i, column k: of tau[i] by q[k]"),
                    matrix_output("dtau_dqd", n, n, by_velocity, "row i, column k: of tau[i] by qd[k]")};
  return result;
}

// Differentiates B q̈ + n(q, q̇) = τ: B ∂q̈ = -∂(B q̈ + n) at this q̈.
Function multipliers_and_derivatives_along_loops(const Mechanism& mechanism, const Choices& choices) {
  Function result = derive_multipliers_and_inverse(mechanism, choices);
  const Output qdd = result.outputs[0], lambda = result.outputs[1], inverse = result.outputs[2];
  const std::vector<Output> torques =
      outputs_at(torque_derivatives_along_loops(mechanism, choices), qdd.entries, {}, result);
  const int n = mechanism.size();
  const SquareMatrices m(result.graph, n);
  const auto accelerations = [&](const Output& of_torques) {
    return m.product(m.scaled(result.graph.constant(-1), inverse.entries), of_torques.entries);
  };
  result.outputs = {
      qdd, lambda, matrix_output("dqdd_dq", n, n, accelerations(torques[0]), "row i, column k: of qdd[i] by q[k]"),
      matrix_output("dqdd_dqd", n, n, accelerations(torques[1]), "row i, column k: of qdd[i] by qd[k]"), inverse};
  return result;
}

}  // namespace

Function inverse_dynamics_derivatives(const Mechanism& mechanism, const Choices& choices) {
  return mechanism.has_loops() ? torque_derivatives_along_loops(mechanism, choices)
                               : derive_inverse_dynamics_derivatives(mechanism, choices);
}

Function forward_dynamics_derivatives(const Mechanism& mechanism, const Choices& choices) {
  if (!mechanism.has_loops()) return derive_forward_dynamics_derivatives(mechanism, choices);
  Function result = multipliers_and_derivatives_along_loops(mechanism, choices);
  result.outputs.erase(result.outputs.begin(), result.outputs.begin() + 2);
  return result;
}

Function multipliers_and_derivatives(const Mechanism& mechanism, const Choices& choices) {
  return mechanism.has_loops() ? multipliers_and_derivatives_along_loops(mechanism, choices)
                               : derive_multipliers_and_derivatives(mechanism, choices);
}

}  // namespace flatdyn
