// SPDX-License-Identifier: GPL-2.0-or-later
// The implicit midpoint rule: derivation/dynamics/midpoint.hpp has its equations.
#include <utility>

#include "truth/definition/acceleration_derivatives.hpp"
#include "truth/definition/elimination_over_field.hpp"
#include "truth/definition/rules.hpp"
#include "truth/definition/stage_arithmetic.hpp"
#include "truth/definition/step_definitions.hpp"

namespace flatdyn::definitions {
namespace {

// The middle of a step: the torques there, how they change, and the matrix of Newton's method.
template <class F>
struct MiddleOfStep {
  F h, half;
  std::vector<F> qd, qd_end, residual;
  Matrix<F> by_q, by_qd, inertia, newton;
};

template <class Point, class F = typename Point::F>
MiddleOfStep<F> middle_of_step(const Point& at) {
  const int n = at.mechanism.size();
  const F h = at.arithmetic.input({InputKind::h, 0}), half = h / F(2);
  MiddleOfStep<F> step{h, half, at.qd(), at.drawn(InputKind::qd_end), {}, {}, {}, {}, {}};
  std::vector<F> q = at.drawn(InputKind::q), qd, qdd;
  for (std::size_t k = 0; k < q.size(); ++k) {
    qd.push_back((step.qd[k] + step.qd_end[k]) / F(2));
    qdd.push_back((step.qd_end[k] - step.qd[k]) / h);
    q[k] += half * qd[k];
  }
  StageArithmetic<F> arithmetic(at.arithmetic, q, qd, qdd, F(2));  // q̇ + q̇' for their mean
  const std::vector<F> none;
  DefinitionPoint<StageArithmetic<F>> middle(at.mechanism, at.function, arithmetic, none);
  step.residual = middle.inverse_dynamics();
  const std::vector<F> tau = at.drawn(InputKind::tau);
  for (std::size_t k = 0; k < tau.size(); ++k) step.residual[k] += -tau[k];
  step.by_q = Matrix<F>(n, torque_derivatives_by_position(middle, qdd));
  step.by_qd = Matrix<F>(n, torque_derivatives_by_rate(middle));
  step.inertia = middle.lagrangian.inertia();
  step.newton = step.inertia;
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) step.newton(i, k) += half * (step.by_qd(i, k) + half * step.by_q(i, k));
  }
  return step;
}

template <class Point>
typename Point::Values after_newton_iteration(const Point& at, const Output& output) {
  const auto step = middle_of_step(at);
  if (output.quantity == OutputQuantity::joint_torque) return step.residual;
  auto rates = step.qd_end;
  const auto change = solution(step.newton, step.residual);
  for (std::size_t k = 0; k < rates.size(); ++k) rates[k] += -(step.h * change[k]);
  if (output.quantity == OutputQuantity::joint_rate) return rates;
  auto positions = at.drawn(InputKind::q);
  for (std::size_t k = 0; k < rates.size(); ++k) positions[k] += step.half * (step.qd[k] + rates[k]);
  return positions;
}

template <class Point>
typename Point::Values midpoint_derivatives(const Point& at, const Output& output) {
  using F = typename Point::F;
  const auto step = middle_of_step(at);
  const int n = at.mechanism.size(), first = output.cols == n ? 2 * n : 0;
  Matrix<F> right(n, 3 * n);
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) {
      right(i, k) = -(step.h * step.by_q(i, k));
      right(i, n + k) = step.inertia(i, k) - step.half * (step.by_qd(i, k) + step.half * step.by_q(i, k));
    }
    right(i, 2 * n + i) = step.h;
  }
  const Matrix<F> rates = solution(step.newton, right);
  std::vector<F> result;
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < output.cols; ++k) {
      F entry = step.half * rates(i, first + k);
      if (first + k == i) entry += F(1);
      if (first + k == n + i) entry += step.half;
      result.push_back(entry);
    }
  }
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < output.cols; ++k) result.push_back(rates(i, first + k));
  }
  return result;
}

// Solutions have n factors of the matrix, each with the derivatives of the torques.
double degree_of_iteration(const Mechanism& mechanism, const Function&) { return 4 + 6.0 * mechanism.size(); }

}  // namespace

constinit const Definition midpoint_step = {
    .expected = rules([](auto& at, const Output& output) { return after_newton_iteration(at, output); }),
    .found = kOwnValues,
    .degree_factor = degree_of_iteration,
};

constinit const Definition midpoint_step_derivatives = {
    .expected = rules([](auto& at, const Output& output) { return midpoint_derivatives(at, output); }),
    .found = kOwnValues,
    .degree_factor = degree_of_iteration,
};

}  // namespace flatdyn::definitions
