// SPDX-License-Identifier: GPL-2.0-or-later
// Robot → Robot: snaps numbers that exporters leave where a zero is meant (1.2e-17 m) to zero, since exact arithmetic
// would carry them through the whole code. Each one is recorded in `snaps`. Numbers with free symbols stay as they are.
#pragma once

#include "robot/model/robot.hpp"

namespace flatdyn {

// The largest length in the parts that joints move, m, at most 100 m. The position of the base does not count (map
// coordinates, a table below an insect), unless there are no other lengths. Lengths with symbols do not count.
GiNaC::numeric robot_size(const Robot& robot);

// Dust is a number smaller than `part` of a reference; it is snapped to zero. If `part` is 0, nothing changes. The tree
// must be valid. The references:
//   axes        their own length; an axis within `part` of a multiple of pi/12 in a plane of two coordinate axes is
//               snapped to that angle
//   lengths     the robot's size: an offset of 1e-6 m is never dust
//   products    of inertia: the smaller moment about the two axes; they stay if the body would be physically
//               impossible without them
//   gravity     its magnitude
void snap_dust(const Number& part, Robot& robot);

}  // namespace flatdyn
