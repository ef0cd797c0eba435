// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "diagnostics/diagnostics.hpp"
#include "model/robot.hpp"

namespace flatdyn {

// Makes the robot's base float if one of these joints, of type "floating", is between a root link without a body of its
// own and all others: the joint and that link are left out, and the joint's child becomes the base. Other joints of
// that type are reported as unsupported. `joints`: indices, with places in the file.
void take_floating_joints(const std::vector<int>& joints, Diagnostics& diagnostics, Robot& robot);

}  // namespace flatdyn
