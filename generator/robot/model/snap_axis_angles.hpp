// SPDX-License-Identifier: GPL-2.0-or-later
// Robot → Robot: snaps joint frames that are perpendicular or parallel up to dust, but aligned with none of the file's
// frames.
#pragma once

#include "robot/model/mechanism.hpp"

namespace flatdyn {

// Where the angle between two joints' axes, or the constant part of a joint's own angle, is within `part` (rad) of a
// multiple of pi/12, turns the joint's origin by the missing angle, to within 1e-40 like all angles, and records that
// in `snaps`. `mechanism` is that of the robot, before and after.
void snap_axis_angles(const Number& part, Robot& robot, Mechanism& mechanism);

}  // namespace flatdyn
