// SPDX-License-Identifier: GPL-2.0-or-later
// The limits that those of coupled joints imply for the coordinates.
#pragma once

#include <vector>

#include "robot/model/coupling.hpp"

namespace flatdyn {

// The limits of the coordinate that belongs to joint `owner`, from all joints that follow it alone, the owner among
// them if its position does; the effort is that of the coordinate's own drive. `positions` as from joint_positions().
Limits coordinate_limits(const Robot& robot, const std::vector<LinearPosition>& positions, int owner);

// Checks that coordinates move the joints independently and that limits leave them a range. Limits that do not bound a
// single coordinate are noted.
void check_coordinates(const Robot& robot, Diagnostics& diagnostics);

}  // namespace flatdyn
