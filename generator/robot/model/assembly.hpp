// SPDX-License-Identifier: GPL-2.0-or-later
// The branch in which closed loops are assembled: elbow up or down.
#pragma once

#include "base/diagnostics/diagnostics.hpp"
#include "robot/model/mechanism.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

// Reports joint names that do not exist or whose positions are not entries of q as errors.
void check_assembly(const Robot& robot, Diagnostics& diagnostics);

// Positions near which the loops are closed, by entry of q, rad or m: the robot file's [assembly], else 0.
std::vector<double> assembled_positions(const Robot& robot, const Mechanism& mechanism);

}  // namespace flatdyn
