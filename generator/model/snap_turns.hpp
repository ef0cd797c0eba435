// SPDX-License-Identifier: GPL-2.0-or-later
// Robot → Robot: frames that lie along none of the file's are at right angles, or parallel, but for dust.
#pragma once

#include "model/mechanism.hpp"

namespace flatdyn {

// Where the angle between two joints' axes, or the constant part of a joint's own angle, is within `part` (rad) of a
// multiple of pi/12, the joint's origin is turned by what is missing; recorded in `snaps`. `mechanism` is that of the
// robot, before and after. To 1e-40, as all angles are.
void snap_turns(const Number& part, Robot& robot, Mechanism& mechanism);

}  // namespace flatdyn
