// SPDX-License-Identifier: GPL-2.0-or-later
// Robot → Robot: numbers that exporters leave where a zero is meant (1.2e-17 m) become zero, since exact arithmetic
// would carry them through the whole code. Each one is recorded in `snaps`. Numbers with free symbols stay as they are.
#pragma once

#include "model/robot.hpp"

namespace flatdyn {

// The largest length of what joints move, at most 100 m. Where the base stands says nothing of what is tiny in the
// robot (map coordinates, a table below an insect), unless nothing else has a length. Lengths with symbols do not
// count.
GiNaC::numeric robot_size(const Robot& robot);

// What is smaller than `part` of what it stands beside is dust. 0 leaves all as it is. The tree has to be valid.
//   axes        beside their own length; within `part` of a multiple of pi/12 in a plane of two coordinate axes they
//   are
//               at that angle, exactly
//   lengths     beside the robot's size: an offset of 1e-6 m is never dust
//   products    of inertia, beside the smaller moment about the two axes; they stay if only they make the body one that
//               can exist
//   gravity     beside its magnitude
void snap_dust(const Number& part, Robot& robot);

}  // namespace flatdyn
