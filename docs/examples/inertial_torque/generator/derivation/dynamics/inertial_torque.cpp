// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/inertial_torque.hpp"

namespace flatdyn {

Function derive_inertial_torque(const Mechanism& mechanism, const Choices& choices) {
  return derived(mechanism, choices, [](DerivationContext& context) {
    const Rows B = context.inertia();
    const std::vector<Number> qdd = context.all(InputKind::qdd);
    std::vector<Number> tau;
    for (const std::vector<Number>& row : B) {
      Number sum = 0;
      for (std::size_t j = 0; j < qdd.size(); ++j) sum += row[j] * qdd[j];
      tau.push_back(sum);
    }
    return finished(context, {torque_output("tau", context.nodes(tau))});
  });
}

}  // namespace flatdyn
