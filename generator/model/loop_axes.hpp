// SPDX-License-Identifier: GPL-2.0-or-later
// What loops have that are closed along axes, and where they are closed as they stand at q = 0.
#pragma once

#include "diagnostics/diagnostics.hpp"
#include "model/robot.hpp"

namespace flatdyn {

// Second points of loops that are given by the position of all joints at 0 (Loop::meets_at_zero), in exact numbers.
void close_at_zero(Robot& robot);

// Of two lines that stay on each other, flatdyn's loops keep the points on each other. That is all where the joints
// keep the lines parallel whatever their positions, as in a mechanism in a plane: decided in 50 digits at one position.
// Other loops along axes take two coordinates more (a revolute joint in space): they are unsupported, and an error
// where the axes are never parallel. For loops that check_loops() has found right.
void check_loop_axes(const Robot& robot, Diagnostics& diagnostics);

}  // namespace flatdyn
