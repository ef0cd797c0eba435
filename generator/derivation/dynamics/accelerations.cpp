// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/accelerations.hpp"

namespace flatdyn {

std::vector<Number> bias_torques(DerivationContext& context) {
  const Motion motion{context.joint_motion(InputKind::qd), context.joint_drift(), context.gravity(), true};
  return context.at_coordinates(torques(context.frames, motion));
}

std::vector<Number> accelerations(DerivationContext& context, const Factorisation& B) {
  return accelerations(context, B, bias_torques(context));
}

std::vector<Number> accelerations(DerivationContext& context, const Factorisation& B, const std::vector<Number>& bias) {
  const std::vector<Number> tau = context.all(InputKind::tau);
  std::vector<Number> b = bias;
  for (std::size_t i = 0; i < b.size(); ++i) {
    b[i] = context.derivation.named(tau[i] - b[i], "y_" + context.frames.label(static_cast<int>(i)));
  }
  return B.solve(b, "qdd");
}

}  // namespace flatdyn
