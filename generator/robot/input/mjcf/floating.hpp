// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "robot/input/mjcf/model.hpp"

namespace flatdyn {

// Makes the base float if the robot has one free joint, in a body of the world, and nothing of the world has a mass or
// carries anything else: the joint and the world are left out, and the body becomes the base, with the joint's armature
// and friction. Other free joints are reported as unsupported.
void take_mjcf_free_joints(MjcfModel& model);

}  // namespace flatdyn
