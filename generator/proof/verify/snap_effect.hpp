// SPDX-License-Identifier: GPL-2.0-or-later
// The effect of snapping numbers of the robot file to exact ones.
#pragma once

#include <optional>
#include <vector>

#include "functions/load/loaded_robot.hpp"
#include "robot/input/common/read_options.hpp"

namespace flatdyn {

// The change of a joint's torque from its value with the number as written, N m; N for a prismatic joint.
struct SnapEffect {
  double seen = 0;  // the largest of any joint at a few random states within the limits, in 50 digits
  std::optional<double>
      bound;  // proven for any joint and motion within the limits (proof/verify/torque_difference.hpp)
};

// The limits are those of robot/model/states.hpp: MotionRange. Bounds are there if no joints are coupled or in closed
// loops, and the file has no free symbols.
struct SnapEffects {
  std::vector<SnapEffect> each;  // one for each of model.robot.snaps
  std::optional<double> bound;   // proven, of all snaps together
};

// Free symbols get random values. `options`: those that the model was read with.
SnapEffects snap_effects(const LoadedRobot& model, const ReadOptions& options);

}  // namespace flatdyn
