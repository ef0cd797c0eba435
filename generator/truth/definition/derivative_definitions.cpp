// SPDX-License-Identifier: GPL-2.0-or-later
#include "truth/definition/derivative_definitions.hpp"

#include "truth/definition/rules.hpp"
#include "truth/definition/torque_derivatives.hpp"

namespace flatdyn::definitions {
namespace {

// ∂τ/∂q̇.
template <class Point>
auto torque_derivatives_by_rate(Point& at) {
  auto result = torques_by_rate(at.lagrangian, at.qd());
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

// The values that B times the derivatives must have. Where q̈ is needed, it is B⁻¹ (τ - n) with the function's own B⁻¹,
// which is compared, too.
template <class Point>
auto acceleration_derivatives(Point& at, const Output& output) {
  using F = typename Point::F;
  const int n = at.mechanism.size();
  if (output.quantity == OutputQuantity::acceleration_per_torque) {
    Matrix<F> unit(n, n);
    for (int i = 0; i < n; ++i) unit(i, i) = F(1);
    return unit.entries();
  }
  std::vector<F> result;
  if (output.quantity == OutputQuantity::acceleration_per_position) {
    const Matrix<F> inverse(n, at.own(at.function.outputs.back()));
    result = torque_derivatives_by_position(at, times(inverse, at.net_torques()));
  } else {
    result = torque_derivatives_by_rate(at);
  }
  for (F& entry : result) entry = -entry;
  return result;
}

}  // namespace

constinit const Definition inverse_dynamics_derivatives = defined_as([](auto& at, const Output& output) {
  if (output.quantity == OutputQuantity::torque_per_rate) return torque_derivatives_by_rate(at);
  return torque_derivatives_by_position(at, at.qdd());
});

constinit const Definition forward_dynamics_derivatives = {
    .expected = rules([](auto& at, const Output& output) { return acceleration_derivatives(at, output); }),
    .found = rules([](auto& at, const Output& output) {
      using F = typename std::decay_t<decltype(at)>::F;
      return times(at.lagrangian.inertia(), Matrix<F>(output.cols, at.own(output))).entries();
    }),
    // They are compared at a q̈ computed from the function's own B⁻¹ and a torque.
    .degree_factor = [](const Mechanism&, const Function&) { return 2.0; },
};

}  // namespace flatdyn::definitions
