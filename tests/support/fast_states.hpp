// SPDX-License-Identifier: GPL-2.0-or-later
// States with fast motion.
#pragma once

#include <cmath>

#include "proof/certify/input_limits.hpp"
#include "robot/model/states.hpp"

namespace flatdyn::testing {

// Random states; every second one is at the limits of all rates and accelerations.
inline std::vector<State> fast_states(const Mechanism& mechanism, int count) {
  const InputLimits limits = input_limits(mechanism);
  std::vector<State> states = random_states(mechanism, count, 1);
  for (std::size_t k = 1; k < states.size(); k += 2) {
    for (int i = 0; i < mechanism.size(); ++i) {
      double &qd = states[k].qd[static_cast<std::size_t>(i)], &qdd = states[k].qdd[static_cast<std::size_t>(i)];
      qd = std::copysign(limits({InputKind::qd, i}), qd);
      qdd = std::copysign(limits({InputKind::qdd, i}), qdd);
    }
  }
  return states;
}

}  // namespace flatdyn::testing
