// SPDX-License-Identifier: GPL-2.0-or-later
// Robots of robots/ whose joints all have limits.
#pragma once

#include "planning/formulations.hpp"
#include "support/robot_models.hpp"

namespace flatdyn::testing {

// Every joint moves at up to 2 /s and 10 /s^2, and takes 100 N m (N); prismatic ones half a metre each way.
inline Mechanism within_limits(Mechanism mechanism) {
  for (Body& body : mechanism.bodies) {
    body.limits.velocity = Value{2, {}};
    body.limits.acceleration = Value{10, {}};
    body.limits.effort = Value{100, {}};
    if (!body.prismatic) continue;
    body.limits.upper = Value{Number(1) / 2, {}};
    body.limits.lower = Value{Number(-1) / 2, {}};
  }
  return mechanism;
}

inline Mechanism limited_robot(const std::string& file) { return within_limits(model_of(file).mechanism); }

}  // namespace flatdyn::testing
