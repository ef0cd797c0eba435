// SPDX-License-Identifier: GPL-2.0-or-later
// Planar joints of a URDF.
#pragma once

#include "robot/input/common/context.hpp"

namespace flatdyn {

// Instead of a joint that was read as a continuous one: slides along x and y of its plane and a turn in it, NAME.x,
// NAME.y, NAME.turn, with links without mass between them. Friction, springs, motors and couplings of the whole joint
// are refused: the file does not say which of the three is meant.
void split_planar_joint(const std::string& name, ReadContext& context, Robot& robot);

}  // namespace flatdyn
