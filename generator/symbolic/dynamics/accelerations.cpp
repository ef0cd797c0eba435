// SPDX-License-Identifier: GPL-2.0-or-later
#include "symbolic/dynamics/accelerations.hpp"

namespace flatdyn {

std::vector<Number> bias_torques(Workbench& bench) {
  const Motion motion{bench.joint_motion(InputKind::qd), bench.joint_drift(), bench.mechanism.gravity, true};
  return bench.at_coordinates(torques(bench.frames, motion));
}

std::vector<Number> accelerations(Workbench& bench, const Factorisation& B) {
  return accelerations(bench, B, bias_torques(bench));
}

std::vector<Number> accelerations(Workbench& bench, const Factorisation& B, const std::vector<Number>& bias) {
  const std::vector<Number> tau = bench.all(InputKind::tau);
  std::vector<Number> b = bias;
  for (std::size_t i = 0; i < b.size(); ++i) {
    b[i] = bench.derivation.named(tau[i] - b[i], "y_" + label(static_cast<int>(i)));
  }
  return B.solve(b, "qdd");
}

}  // namespace flatdyn
