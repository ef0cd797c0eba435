// SPDX-License-Identifier: GPL-2.0-or-later
// Robots of robots/ with limits for all joints.
#pragma once

#include "functions/planning/formulations.hpp"
#include "support/robot_models.hpp"

namespace flatdyn::testing {

// Sets limits: every joint moves at up to 2 /s and 10 /s^2 and exerts up to 100 N m (N); prismatic ones move half a
// metre each way.
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

// With "floating " before the file its base moves freely, too.
inline Mechanism limited_robot(const std::string& file) {
  const std::string floating = "floating ";
  if (!file.starts_with(floating)) return within_limits(model_of(file).mechanism);
  LoadOptions options;
  options.read.floating_base = true;
  return within_limits(
      load_robot(std::filesystem::path(FLATDYN_SOURCE_DIR) / "robots" / file.substr(floating.size()), options)
          .mechanism);
}

}  // namespace flatdyn::testing
