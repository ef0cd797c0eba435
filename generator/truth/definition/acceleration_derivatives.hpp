// SPDX-License-Identifier: GPL-2.0-or-later
// Derivatives of torques and accelerations at a point of a field.
#pragma once

#include <vector>

#include "truth/definition/definition_point.hpp"
#include "truth/definition/torque_derivatives.hpp"

namespace flatdyn {

// ∂τ/∂q̇.
template <class Point>
auto torque_derivatives_by_rate(Point& at) {
  auto result = torques_by_rate(at.lagrangian, at.qd(), at.signs());
  if (at.mechanism.has_quasi_velocities()) {
    add_drift_by_rate(at.mechanism, at.lagrangian.inertia(), at.qd(), result);
  }
  return result.entries();
}

// ∂τ/∂q at these accelerations.
template <class Point>
auto torque_derivatives_by_position(Point& at, const typename Point::Values& qdd) {
  return torques_by_position(
             at.mechanism, at.arithmetic,
             {at.q, at.qd(), at.accelerations_of_coordinates(qdd), at.signs(), at.lagrangian.mechanism().gravity})
      .entries();
}

// The values that B times the derivatives of q̈ by positions, rates or torques must have. Where q̈ is needed, it is
// B⁻¹ (τ - n) with the function's own B⁻¹, which is compared, too.
template <class Point>
auto acceleration_derivatives(Point& at, OutputQuantity quantity, const Matrix<typename Point::F>& own_inverse) {
  using F = typename Point::F;
  const int n = at.mechanism.size();
  if (quantity == OutputQuantity::acceleration_per_torque) {
    Matrix<F> unit(n, n);
    for (int i = 0; i < n; ++i) unit(i, i) = F(1);
    return unit.entries();
  }
  std::vector<F> result = quantity == OutputQuantity::acceleration_per_position
                              ? torque_derivatives_by_position(at, times(own_inverse, at.net_torques()))
                              : torque_derivatives_by_rate(at);
  for (F& entry : result) entry = -entry;
  return result;
}

}  // namespace flatdyn
