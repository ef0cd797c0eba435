// SPDX-License-Identifier: GPL-2.0-or-later
// What the limits of coupled joints leave to the coordinates.
#pragma once

#include <vector>

#include "model/coupling.hpp"

namespace flatdyn {

// Of the coordinate that belongs to a joint: the limits of all joints that follow it alone, this one among them if its
// position does; effort as that of its own drive. `positions`: as from joint_positions().
Limits coordinate_limits(const Robot& robot, const std::vector<LinearPosition>& positions, int owner);

// Coordinates move the joints independently, and limits leave them room. Limits that bound no single coordinate are
// noted.
void check_coordinates(const Robot& robot, Diagnostics& diagnostics);

}  // namespace flatdyn
