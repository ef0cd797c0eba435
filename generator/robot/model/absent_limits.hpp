// SPDX-License-Identifier: GPL-2.0-or-later
// Placeholder limits that files have where a joint has no limits. Whoever draws or plans states within limits has to
// know.
#pragma once

#include "base/diagnostics/diagnostics.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

// Takes such limits away from a joint, each with a note:
//   - zeros that exporters write for what nobody gave: lower = upper = 0, velocity = 0, ...
//   - positions beyond 1e4 rad or m; velocities, accelerations and efforts beyond 1e6 (Gazebo writes 1e16);
//   - lower = 1 and upper = 0, which is Bullet's word for no limit.
void remove_absent_limits(Joint& joint, Diagnostics& diagnostics);

}  // namespace flatdyn
