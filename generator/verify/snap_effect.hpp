// SPDX-License-Identifier: GPL-2.0-or-later
// The effect of snapping numbers of the robot file to exact ones.
#pragma once

#include "input/common/read_options.hpp"
#include "load/loaded_robot.hpp"

namespace flatdyn {

// For each of model.robot.snaps: the largest change of any joint's torque (N m; N for a prismatic joint) from its value
// with the number as written, over a few random states within the limits, by the reference in 50 digits. Free symbols
// get random values. `options`: those that the model was read with.
std::vector<double> snap_effects(const LoadedRobot& model, const ReadOptions& options);

}  // namespace flatdyn
