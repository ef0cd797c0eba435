// SPDX-License-Identifier: GPL-2.0-or-later
// What taking numbers of the robot file for exact ones changes.
#pragma once

#include "load/loaded_robot.hpp"

namespace flatdyn {

// For each of model.robot.snaps: the largest change of any joint's torque (N m; N for a prismatic joint) against the
// number as written, over a few random states within the limits, from the reference in 50 digits. Free symbols get
// random values. `options`: those that the model was read with.
std::vector<double> snap_effects(const LoadedRobot& model, const ReadOptions& options);

}  // namespace flatdyn
