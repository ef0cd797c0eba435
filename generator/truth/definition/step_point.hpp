// SPDX-License-Identifier: GPL-2.0-or-later
// The definitions of steps share this: the state before a step at a point of a field, the outputs after it, and how
// they change with that state and τ.
#pragma once

#include <utility>
#include <vector>

#include "truth/definition/definition_point.hpp"
#include "truth/definition/stage_arithmetic.hpp"

namespace flatdyn {

template <class Point>
typename Point::F step_length(const Point& at) {
  return at.arithmetic.input({InputKind::h, 0});
}

template <class Point, class F = typename Point::F>
PositionsOfStep<F> positions_before(const Point& at) {
  PositionsOfStep<F> positions{at.drawn(InputKind::q, at.mechanism.position_count()), {F(0), F(0), F(0)}};
  if (!at.mechanism.has_base_gravity()) return positions;
  for (int k = 0; k < 3; ++k) {
    positions.g_b[static_cast<std::size_t>(k)] = at.arithmetic.input({InputKind::g_b, k});
  }
  return positions;
}

// The entries of an output of a step, but for a residual.
template <class Point, class F = typename Point::F>
std::vector<F> after_step(const Point& at, const Output& output, const ChangeOfPositions<F>& change,
                          const std::vector<F>& qd) {
  if (output.quantity == OutputQuantity::joint_rate) return qd;
  if (output.quantity == OutputQuantity::number) return {change.turns[0].begin(), change.turns[0].end()};
  if (output.quantity == OutputQuantity::position) return {change.entries.begin(), change.entries.begin() + 3};
  return positions_after(at.mechanism, positions_before(at), change).q;
}

// Derivatives of n values by the state before a step, first by its positions in tangent spaces, then by q̇, and by τ are
// an n × 3n matrix. This one is the identity by one of the three.
enum class StepArgument { position, rate, torque };
template <class F>
Matrix<F> derivatives_of_argument(int n, StepArgument argument) {
  Matrix<F> result(n, 3 * n);
  for (int k = 0; k < n; ++k) result(k, static_cast<int>(argument) * n + k) = F(1);
  return result;
}

// a + factor b.
template <class F>
Matrix<F> moved(Matrix<F> a, const F& factor, const Matrix<F>& b) {
  for (int i = 0; i < a.rows(); ++i) {
    for (int k = 0; k < a.cols(); ++k) a(i, k) += factor * b(i, k);
  }
  return a;
}
template <class F>
std::vector<F> moved(std::vector<F> a, const F& factor, const std::vector<F>& b) {
  for (std::size_t k = 0; k < a.size(); ++k) a[k] += factor * b[k];
  return a;
}

// The values as dual numbers along a column of their derivatives.
template <class F>
std::vector<Dual<F>> along(const std::vector<F>& values, const Matrix<F>& derivatives, int column) {
  std::vector<Dual<F>> result;
  for (const F& value : values) result.emplace_back(value, derivatives(static_cast<int>(result.size()), column));
  return result;
}

// The derivatives of positions after a change, which follows from numbers and their derivatives.
template <class F, class Change>
Matrix<F> derivatives_after(const Mechanism& mechanism, const std::vector<F>& numbers, const Matrix<F>& derivatives,
                            const Change& change) {
  const int n = mechanism.size();
  Matrix<F> result(n, derivatives.cols());
  for (int column = 0; column < derivatives.cols(); ++column) {
    std::vector<F> delta(static_cast<std::size_t>(n), F(0));
    if (column < n) delta[static_cast<std::size_t>(column)] = F(1);
    const std::vector<F> after =
        tangent_after(mechanism, std::move(delta), change(mechanism, along(numbers, derivatives, column)));
    for (int i = 0; i < n; ++i) result(i, column) = after[static_cast<std::size_t>(i)];
  }
  return result;
}

// The entries of A or B from the derivatives of positions and of rates after a step.
template <class F>
std::vector<F> state_derivatives(const Output& output, const Matrix<F>& positions, const Matrix<F>& rates) {
  const int n = positions.rows(), first = output.cols == n ? 2 * n : 0;
  std::vector<F> result;
  for (const Matrix<F>* rows : {&positions, &rates}) {
    for (int i = 0; i < n; ++i) {
      for (int k = 0; k < output.cols; ++k) result.push_back((*rows)(i, first + k));
    }
  }
  return result;
}

}  // namespace flatdyn
