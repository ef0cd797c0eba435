// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/derivative_functions.hpp"

#include <utility>

#include "derivation/dynamics/accelerations.hpp"
#include "derivation/dynamics/composite.hpp"
#include "derivation/dynamics/derivatives.hpp"

namespace flatdyn {
namespace {

constexpr std::size_t kDirections = 3;

Output derivative_output(DerivationContext& context, const std::string& name, const Rows& rows,
                         const std::string& meaning) {
  return matrix_output(name, context.size(), context.size(), context.nodes(rows), meaning);
}

TorqueDerivatives derivatives_at_coordinates(DerivationContext& context, const Motion& motion,
                                             BaseColumns base_columns) {
  const TorqueDerivatives tau = torque_derivatives(context.frames, motion, base_columns);
  const auto folded = [&context](const Rows& rows, const std::string& name) {
    return at_coordinates(context.mechanism, context.derivation, rows, Shape::general, name);
  };
  return {folded(tau.dq, "dtau"), folded(tau.dqd, "dtaud")};
}

struct AccelerationDerivatives {
  Rows dq, dqd;
  std::vector<Number> qdd;
};

std::vector<Output> acceleration_outputs(DerivationContext& context, const AccelerationDerivatives& qdd) {
  return {derivative_output(context, "dqdd_dq", qdd.dq, "row i, column k: of qdd[i] by q[k]"),
          derivative_output(context, "dqdd_dqd", qdd.dqd, "row i, column k: of qdd[i] by qd[k]")};
}

// The same and the derivatives by τ.
std::vector<Output> all_acceleration_outputs(DerivationContext& context, const AccelerationDerivatives& qdd,
                                             const Rows& inverse) {
  std::vector<Output> outputs = acceleration_outputs(context, qdd);
  outputs.push_back(derivative_output(context, "dqdd_dtau", inverse, "the inverse of B"));
  return outputs;
}

// -B⁻¹ times a matrix.
Rows solved(DerivationContext& context, const Factorisation& B, const Rows& matrix, const std::string& name) {
  Rows result = matrix;
  for (std::size_t k = 0; k < matrix.size(); ++k) {
    std::vector<Number> column;
    for (const std::vector<Number>& row : matrix) column.push_back(-row[k]);
    column = B.solve(column, name + "_" + label(static_cast<int>(k), context.mechanism.base_bodies()));
    for (std::size_t i = 0; i < matrix.size(); ++i) result[i][k] = column[i];
  }
  return result;
}

Function torque_derivatives_function(DerivationContext& context) {
  const Motion motion{context.joint_motion(InputKind::qd), context.joint_motion(InputKind::qdd), context.gravity(),
                      true};
  const TorqueDerivatives tau = derivatives_at_coordinates(context, motion, BaseColumns::derivatives);
  return finished(context, {derivative_output(context, "dtau_dq", tau.dq, "row i, column k: of tau[i] by q[k]"),
                            derivative_output(context, "dtau_dqd", tau.dqd, "row i, column k: of tau[i] by qd[k]")});
}

// Gravity and the base's velocity v accelerate the whole robot alike: τ depends on v, v̇ and g_b by the acceleration of
// the base's origin p̈ = v̇ + ω × v - g_b only. While the other rows are those of p̈, v̇ is p̈ - ω × v + g_b.
void add_rates_of_base_axes(DerivationContext& context, const Motion& motion, Rows& dq, Rows& dqd) {
  if (!context.mechanism.floating_base) return;
  Derivation& d = context.derivation;
  const auto& qd = motion.qd;
  const Mat3 of_v = skew({qd[0], qd[1], qd[2]}), of_omega = skew({qd[3], qd[4], qd[5]}), of_g = skew(motion.gravity);
  for (std::size_t i = 0; i < kDirections; ++i) {
    for (std::size_t j = 0; j < kDirections; ++j) {
      const std::string n = "_b_" + std::to_string(i) + std::to_string(j);
      Number &by_turn = dq[i][j + kDirections], &by_v = dqd[i][j], &by_omega = dqd[i][j + kDirections];
      by_turn = d.named(by_turn + of_g[i][j], "da_turn" + n);     // g_b × e_j
      by_v = d.named(by_v - of_omega[i][j], "da_v" + n);          // -ω × e_j
      by_omega = d.named(by_omega + of_v[i][j], "da_omega" + n);  // -e_j × v
    }
  }
}

// Differentiates B q̈ + n(q, q̇) = τ: B ∂q̈ = -∂(B q̈ + n) at this q̈.
AccelerationDerivatives derivatives_by_substitution(DerivationContext& context, const Factorisation& B) {
  const std::vector<Number> qdd = accelerations(context, B);
  const Motion motion{context.joint_motion(InputKind::qd),
                      joint_motion(context.mechanism, context.derivation, qdd, "qdd_j"), context.gravity(), true};
  const TorqueDerivatives tau = derivatives_at_coordinates(context, motion, BaseColumns::at_origin_acceleration);
  AccelerationDerivatives result{solved(context, B, tau.dq, "dqdd"), solved(context, B, tau.dqd, "dqddd"), qdd};
  add_rates_of_base_axes(context, motion, result.dq, result.dqd);
  return result;
}

Function acceleration_derivatives_function(DerivationContext& context) {
  const Factorisation B(context.frames, context.inertia());
  const AccelerationDerivatives qdd = derivatives_by_substitution(context, B);
  return finished(context, all_acceleration_outputs(context, qdd, B.inverse("a")), conditions_of(context, B));
}

// -B⁻¹ times a matrix, whose entries are named.
Rows less_product(DerivationContext& context, const Rows& inverse, const Rows& matrix, const std::string& name) {
  Derivation& d = context.derivation;
  Rows result(matrix.size(), std::vector<Number>(matrix.size(), 0));
  for (std::size_t k = 0; k < matrix.size(); ++k) {
    std::vector<Number> column;
    for (std::size_t j = 0; j < matrix.size(); ++j) {
      column.push_back(d.named(matrix[j][k], name + "_" + std::to_string(j + 1) + "_" + std::to_string(k + 1)));
    }
    for (std::size_t i = 0; i < matrix.size(); ++i) result[i][k] = -sum_of(inverse[i], column);
  }
  return result;
}

// q̈ = B⁻¹ (τ - n) as a motion, and the derivatives of the torques at it.
struct TorquesAtSolution {
  std::vector<Number> qdd;
  Motion motion;
  TorqueDerivatives torques;
};

TorquesAtSolution torques_at_solution(DerivationContext& context, const Rows& inverse) {
  const std::vector<Number> tau = context.all(InputKind::tau), bias = bias_torques(context);
  std::vector<Number> moving, qdd;
  for (std::size_t i = 0; i < tau.size(); ++i) {
    moving.push_back(context.derivation.named(tau[i] - bias[i], "y_" + context.frames.label(static_cast<int>(i))));
  }
  for (std::size_t i = 0; i < tau.size(); ++i) {
    const std::string name = "qdd_" + context.frames.label(static_cast<int>(i));
    qdd.push_back(context.derivation.named(sum_of(inverse[i], moving), name));
  }
  Motion motion{context.joint_motion(InputKind::qd), joint_motion(context.mechanism, context.derivation, qdd, "qdd_j"),
                context.gravity(), true};
  TorqueDerivatives torques = derivatives_at_coordinates(context, motion, BaseColumns::at_origin_acceleration);
  return {qdd, std::move(motion), std::move(torques)};
}

// As acceleration_derivatives_function(), with the columns by products.
AccelerationDerivatives derivatives_by_products(DerivationContext& context, const Rows& inverse) {
  const auto [qdd, motion, torques] = torques_at_solution(context, inverse);
  AccelerationDerivatives result{less_product(context, inverse, torques.dq, "dtau"),
                                 less_product(context, inverse, torques.dqd, "dtaud"), qdd};
  add_rates_of_base_axes(context, motion, result.dq, result.dqd);
  return result;
}

Function function_by_products(DerivationContext& context) {
  const Factorisation B(context.frames, context.inertia());
  const Rows inverse = B.inverse("a");
  const AccelerationDerivatives qdd = derivatives_by_products(context, inverse);
  return finished(context, all_acceleration_outputs(context, qdd, inverse), conditions_of(context, B));
}

Function function_at_solution(DerivationContext& context) {
  const Factorisation B(context.frames, context.inertia());
  const Rows inverse = B.inverse("a");
  const TorquesAtSolution at = torques_at_solution(context, inverse);
  const std::vector<Number> zeros(inverse.size(), 0);
  Rows by_turn(inverse.size(), zeros), by_velocity = by_turn;
  add_rates_of_base_axes(context, at.motion, by_turn, by_velocity);
  return finished(context,
                  {vector_output("qdd", context.nodes(at.qdd), "joint accelerations"),
                   derivative_output(context, "dtau_dq", at.torques.dq, "row i, column k: of tau[i] by q[k]"),
                   derivative_output(context, "dtau_dqd", at.torques.dqd, "row i, column k: of tau[i] by qd[k]"),
                   derivative_output(context, "dqdd_dtau", inverse, "the inverse of B"),
                   derivative_output(context, "axes_dq", by_turn, "what turning axes of the base add to q̈ by q"),
                   derivative_output(context, "axes_dqd", by_velocity, "what turning axes of the base add to q̈ by q̇")},
                  conditions_of(context, B));
}

std::vector<Number> weights_of(DerivationContext& context) {
  return inputs(context.derivation, InputKind::weights, context.size());
}

std::vector<Output> solution_outputs(DerivationContext& context, const std::vector<Number>& qdd,
                                     const std::vector<Number>& lambda) {
  return {vector_output("qdd", context.nodes(qdd), "joint accelerations"),
          vector_output("lambda", context.nodes(lambda), "B^-1 times the weights")};
}

// q̈ and λ.
std::vector<Output> outputs_with_multipliers(DerivationContext& context, const std::vector<Number>& qdd,
                                             const Rows& inverse) {
  const std::vector<Number> weights = weights_of(context);
  std::vector<Number> lambda;
  for (std::size_t i = 0; i < inverse.size(); ++i) {
    const std::string name = "lambda_" + context.frames.label(static_cast<int>(i));
    lambda.push_back(context.derivation.named(sum_of(inverse[i], weights), name));
  }
  return solution_outputs(context, qdd, lambda);
}

Function with_multipliers(DerivationContext& context, const AccelerationDerivatives& qdd, const Rows& inverse,
                          Conditions conditions) {
  std::vector<Output> outputs = outputs_with_multipliers(context, qdd.qdd, inverse);
  for (Output& each : all_acceleration_outputs(context, qdd, inverse)) outputs.push_back(std::move(each));
  return finished(context, std::move(outputs), std::move(conditions));
}

// B⁻¹ as it is stored.
Rows stored_inverse(DerivationContext& context, const std::vector<int>& entries) {
  const auto n = static_cast<std::size_t>(context.size());
  Rows inverse(n, std::vector<Number>(n, 0));
  for (std::size_t k = 0; k < entries.size(); ++k) {
    if (entries[k] >= 0) inverse[k / n][k % n] = context.derivation.input(InputKind::stored, entries[k]);
  }
  return inverse;
}

Function derivatives_from_inverse(DerivationContext& context, const std::vector<int>& entries) {
  const AccelerationDerivatives qdd = derivatives_by_products(context, stored_inverse(context, entries));
  return finished(context, acceleration_outputs(context, qdd));
}

}  // namespace

Function derive_inverse_dynamics_derivatives(const Mechanism& mechanism, const Choices& choices) {
  return derived(mechanism, choices, torque_derivatives_function);
}

Function derive_forward_dynamics_derivatives(const Mechanism& mechanism, const Choices& choices) {
  return derived(mechanism, choices, acceleration_derivatives_function);
}

std::optional<Function> derive_forward_dynamics_derivatives_by_products(const Mechanism& mechanism,
                                                                        const Choices& choices) {
  if (mechanism.has_loops()) return std::nullopt;
  return derived(mechanism, choices, function_by_products);
}

Function derive_torque_derivatives_at_solution(const Mechanism& mechanism, const Choices& choices) {
  return derived(mechanism, choices, function_at_solution);
}

Function derive_acceleration_and_multipliers(const Mechanism& mechanism, const Choices& choices) {
  return derived(mechanism, choices, [](DerivationContext& context) {
    const Factorisation B(context.frames, context.inertia());
    const std::vector<Number> qdd = accelerations(context, B), lambda = B.solve(weights_of(context), "lambda");
    return finished(context, solution_outputs(context, qdd, lambda), conditions_of(context, B));
  });
}

Function derive_multipliers_and_derivatives(const Mechanism& mechanism, const Choices& choices) {
  return derived(mechanism, choices, [](DerivationContext& context) {
    const Factorisation B(context.frames, context.inertia());
    const AccelerationDerivatives qdd = derivatives_by_substitution(context, B);
    return with_multipliers(context, qdd, B.inverse("a"), conditions_of(context, B));
  });
}

Function derive_multipliers_and_derivatives_by_products(const Mechanism& mechanism, const Choices& choices) {
  return derived(mechanism, choices, [](DerivationContext& context) {
    const Factorisation B(context.frames, context.inertia());
    const Rows inverse = B.inverse("a");
    return with_multipliers(context, derivatives_by_products(context, inverse), inverse, conditions_of(context, B));
  });
}

Function derive_multipliers_and_inverse(const Mechanism& mechanism, const Choices& choices) {
  return derived(mechanism, choices, [](DerivationContext& context) {
    const Factorisation B(context.frames, context.inertia());
    const std::vector<Number> qdd = accelerations(context, B);
    const Rows inverse = B.inverse("a");
    std::vector<Output> outputs = outputs_with_multipliers(context, qdd, inverse);
    outputs.push_back(derivative_output(context, "dqdd_dtau", inverse, "the inverse of B"));
    return finished(context, std::move(outputs), conditions_of(context, B));
  });
}

Function derive_acceleration_derivatives_from_inverse(const Mechanism& mechanism, const Choices& choices,
                                                      const std::vector<int>& inverse) {
  return derived(mechanism, choices,
                 [&inverse](DerivationContext& context) { return derivatives_from_inverse(context, inverse); });
}

}  // namespace flatdyn
