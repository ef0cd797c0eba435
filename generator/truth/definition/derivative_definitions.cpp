// SPDX-License-Identifier: GPL-2.0-or-later
#include "truth/definition/derivative_definitions.hpp"

#include "truth/definition/acceleration_derivatives.hpp"
#include "truth/definition/rules.hpp"

namespace flatdyn::definitions {

constinit const Definition inverse_dynamics_derivatives = defined_as([](auto& at, const Output& output) {
  if (output.quantity == OutputQuantity::torque_per_rate) return torque_derivatives_by_rate(at);
  return torque_derivatives_by_position(at, at.qdd());
});

constinit const Definition forward_dynamics_derivatives = {
    .expected = rules([](auto& at, const Output& output) {
      const Matrix inverse(at.mechanism.size(), at.own(at.function.outputs.back()));
      return acceleration_derivatives(at, output.quantity, inverse);
    }),
    .found = rules([](auto& at, const Output& output) {
      using F = typename std::decay_t<decltype(at)>::F;
      return times(at.lagrangian.inertia(), Matrix<F>(output.cols, at.own(output))).entries();
    }),
    // They are compared at a q̈ computed from the function's own B⁻¹ and a torque.
    .degree_factor = [](const Mechanism&, const Function&) { return 2.0; },
};

}  // namespace flatdyn::definitions
