// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "base/diagnostics/diagnostics.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

// Takes limits of position away whose lower one is above the upper one, with a note: Bullet and ODE, for which URDF and
// SDF files are written, have no limit then. Exchanged, they would hold a joint that turns without end. 1 and 0 are
// left to robot/model/absent_limits.hpp.
void remove_exchanged_limits(Joint& joint, Diagnostics& diagnostics);

}  // namespace flatdyn
