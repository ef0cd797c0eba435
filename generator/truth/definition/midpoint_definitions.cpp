// SPDX-License-Identifier: GPL-2.0-or-later
// The implicit midpoint rule: derivation/dynamics/midpoint.hpp has its equations.
#include <utility>

#include "truth/definition/acceleration_derivatives.hpp"
#include "truth/definition/elimination_over_field.hpp"
#include "truth/definition/rules.hpp"
#include "truth/definition/step_definitions.hpp"
#include "truth/definition/step_point.hpp"

namespace flatdyn::definitions {
namespace {

// The middle of a step: the torques there, how they change, and the matrix of Newton's method. Derivatives are those of
// step_point.hpp, with q̇' held fixed.
template <class F>
struct MiddleOfStep {
  F h, half;
  std::vector<F> qd, qd_end, residual;
  Matrix<F> inertia, newton, change_of_torques;
};

// factor (a + b).
template <class F>
std::vector<F> scaled_sum(const F& factor, const std::vector<F>& a, const std::vector<F>& b) {
  std::vector<F> result;
  for (std::size_t k = 0; k < a.size(); ++k) result.push_back(factor * (a[k] + b[k]));
  return result;
}

template <class Point, class F = typename Point::F>
MiddleOfStep<F> middle_of_step(const Point& at) {
  const Mechanism& mechanism = at.mechanism;
  const int n = mechanism.size();
  const F h = step_length(at), half = h / F(2);
  MiddleOfStep<F> step{h, half, at.qd(), at.drawn(InputKind::qd_end), {}, {}, {}, {}};
  const std::vector<F> w = scaled_sum(half, step.qd, step.qd_end), qd = scaled_sum(F(1) / F(2), step.qd, step.qd_end);
  std::vector<F> qdd;
  for (std::size_t k = 0; k < qd.size(); ++k) qdd.push_back((step.qd_end[k] - step.qd[k]) / h);
  const PositionsOfStep<F> positions =
      positions_after(mechanism, positions_before(at), change_to_the_middle(mechanism, w));
  StageArithmetic<F> arithmetic(at.arithmetic, positions, qd, qdd, F(2));  // q̇ + q̇' for their mean
  const std::vector<F> none;
  DefinitionPoint<StageArithmetic<F>> middle(mechanism, at.function, arithmetic, none);
  step.residual = moved(middle.inverse_dynamics(), -F(1), at.drawn(InputKind::tau));
  step.inertia = middle.lagrangian.inertia();
  const Matrix<F> by_q(n, torque_derivatives_by_position(middle, qdd)), by_qd(n, torque_derivatives_by_rate(middle));
  const Matrix<F> of_rates = derivatives_of_argument<F>(n, StepArgument::rate), zero(n, 3 * n);
  const Matrix<F> positions_by = derivatives_after(
      mechanism, w, moved(zero, half, of_rates),
      [](const Mechanism& m, std::vector<Dual<F>> numbers) { return change_to_the_middle(m, std::move(numbers)); });
  // By q̇ as by q̇', but for the acceleration.
  const Matrix<F> by_motion = moved(times(by_q, positions_by), F(1) / F(2), times(by_qd, of_rates));
  step.newton = step.inertia;
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) step.newton(i, k) += h * by_motion(i, n + k);
  }
  step.change_of_torques = moved(by_motion, -(F(1) / h), times(step.inertia, of_rates));
  return step;
}

template <class Point>
typename Point::Values after_newton_iteration(const Point& at, const Output& output) {
  const auto step = middle_of_step(at);
  if (output.quantity == OutputQuantity::joint_momentum_rate) return step.residual;
  const auto rates = moved(step.qd_end, -step.h, solution(step.newton, step.residual));
  return after_step(at, output, change_along(at.mechanism, scaled_sum(step.half, step.qd, rates)), rates);
}

template <class Point>
typename Point::Values midpoint_derivatives(const Point& at, const Output& output) {
  using F = typename Point::F;
  const auto step = middle_of_step(at);
  const int n = at.mechanism.size();
  const Matrix<F> of_rates = derivatives_of_argument<F>(n, StepArgument::rate),
                  of_torques = derivatives_of_argument<F>(n, StepArgument::torque), zero(n, 3 * n);
  const Matrix<F> right = moved(zero, step.h, moved(of_torques, -F(1), step.change_of_torques));
  const Matrix<F> rates = solution(step.newton, right);
  const Matrix<F> change = moved(zero, step.half, moved(of_rates, F(1), rates));
  const Matrix<F> positions = derivatives_after(
      at.mechanism, scaled_sum(step.half, step.qd, step.qd_end), change,
      [](const Mechanism& m, std::vector<Dual<F>> numbers) { return change_along(m, std::move(numbers)); });
  return state_derivatives(output, positions, rates);
}

// Solutions have n factors of the matrix, each with the derivatives of the torques.
double degree_of_iteration(const Mechanism& mechanism, const Function&) {
  return (4 + 6.0 * mechanism.size()) * (mechanism.has_quasi_velocities() ? 2 : 1);
}

}  // namespace

constinit const Definition midpoint_step = {
    .expected = rules([](auto& at, const Output& output) { return after_newton_iteration(at, output); }),
    .found = kOwnValues,
    .degree_factor = degree_of_iteration,
    .is_apart = true,
};

constinit const Definition midpoint_step_derivatives = {
    .expected = rules([](auto& at, const Output& output) { return midpoint_derivatives(at, output); }),
    .found = kOwnValues,
    .degree_factor = degree_of_iteration,
    .is_apart = true,
};

}  // namespace flatdyn::definitions
