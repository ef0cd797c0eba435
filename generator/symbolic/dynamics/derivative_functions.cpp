// SPDX-License-Identifier: GPL-2.0-or-later
#include "symbolic/dynamics/derivative_functions.hpp"

#include "diagnostics/diagnostics.hpp"
#include "symbolic/dynamics/accelerations.hpp"
#include "symbolic/dynamics/composite.hpp"
#include "symbolic/dynamics/derivatives.hpp"

namespace flatdyn {
namespace {

Output derivative_output(DerivationContext& context, const std::string& name, const Rows& rows,
                         const std::string& meaning) {
  return matrix_output(name, context.size(), context.size(), context.nodes(rows), meaning);
}

TorqueDerivatives derivatives_at_coordinates(DerivationContext& context, const Motion& motion) {
  const TorqueDerivatives tau = torque_derivatives(context.frames, motion);
  const auto folded = [&context](const Rows& rows, const std::string& name) {
    return at_coordinates(context.mechanism, context.derivation, rows, Shape::general, name);
  };
  return {folded(tau.dq, "dtau"), folded(tau.dqd, "dtaud")};
}

// The accelerations A q̈ of all bodies' joints.
std::vector<Number> accelerations_of_joints(DerivationContext& context, const Factorisation& B) {
  const std::vector<Number> qdd = accelerations(context, B);
  return joint_motion(context.mechanism, context.derivation, qdd, "qdd_j");
}

// -B⁻¹ times a matrix.
Rows solved(const Factorisation& B, const Rows& matrix, const std::string& name) {
  Rows result = matrix;
  for (std::size_t k = 0; k < matrix.size(); ++k) {
    std::vector<Number> column;
    for (const std::vector<Number>& row : matrix) column.push_back(-row[k]);
    column = B.solve(column, name + "_" + label(static_cast<int>(k)));
    for (std::size_t i = 0; i < matrix.size(); ++i) result[i][k] = column[i];
  }
  return result;
}

Function torque_derivatives_function(DerivationContext& context) {
  const Motion motion{context.joint_motion(InputKind::qd), context.joint_motion(InputKind::qdd), context.gravity(),
                      true};
  const TorqueDerivatives tau = derivatives_at_coordinates(context, motion);
  return finished(context, {derivative_output(context, "dtau_dq", tau.dq, "row i, column k: of tau[i] by q[k]"),
                            derivative_output(context, "dtau_dqd", tau.dqd, "row i, column k: of tau[i] by qd[k]")});
}

// Differentiates B q̈ + n(q, q̇) = τ: B ∂q̈ = -∂(B q̈ + n) at this q̈.
Function acceleration_derivatives_function(DerivationContext& context) {
  const Factorisation B(context.frames, context.inertia());
  const Motion motion{context.joint_motion(InputKind::qd), accelerations_of_joints(context, B), context.gravity(),
                      true};
  const TorqueDerivatives tau = derivatives_at_coordinates(context, motion);
  const Rows dq = solved(B, tau.dq, "dqdd"), dqd = solved(B, tau.dqd, "dqddd");
  const Rows dtau = B.inverse("a");
  Conditions conditions = conditions_of(context, B);
  return finished(context,
                  {derivative_output(context, "dqdd_dq", dq, "row i, column k: of qdd[i] by q[k]"),
                   derivative_output(context, "dqdd_dqd", dqd, "row i, column k: of qdd[i] by qd[k]"),
                   derivative_output(context, "dqdd_dtau", dtau, "the inverse of B")},
                  std::move(conditions));
}

void refuse_loops(const Mechanism& mechanism, const std::string& name) {
  if (!mechanism.has_loops()) return;
  throw Failure(ExitCode::unsupported, name + ": derivatives of robots with closed loops are not supported yet",
                "leave this function out");
}

}  // namespace

Function derive_inverse_dynamics_derivatives(const Mechanism& mechanism, const Choices& choices) {
  refuse_loops(mechanism, "inverse_dynamics_derivatives");
  return derived(mechanism, choices, torque_derivatives_function);
}

Function derive_forward_dynamics_derivatives(const Mechanism& mechanism, const Choices& choices) {
  refuse_loops(mechanism, "forward_dynamics_derivatives");
  return derived(mechanism, choices, acceleration_derivatives_function);
}

}  // namespace flatdyn
