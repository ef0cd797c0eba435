// SPDX-License-Identifier: GPL-2.0-or-later
// Loops that are closed along axes, and loops that are closed as they stand at q = 0.
#pragma once

#include "base/diagnostics/diagnostics.hpp"
#include "robot/model/mechanism.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

// Second points of loops that are given by the position of all joints at 0 (Loop::meets_at_zero), in exact numbers.
void close_at_zero(Robot& robot);

// Whether the points say all of a loop: it has no axes, or its joints keep them parallel whatever their positions, as
// in a mechanism in a plane. Other loops along axes take coordinates more, a revolute joint in space two. Axes that are
// never parallel are an error. Decided in 50 digits at one position. `robot`: has the loop's links, between which
// joints move.
bool is_determined_by_points(const Loop& loop, const Robot& robot, Diagnostics& diagnostics);

// LoopClosure::sense in the robot's tree.
int sense_of_axes(const Robot& robot, const Mechanism& tree, const LoopClosure& loop);

}  // namespace flatdyn
