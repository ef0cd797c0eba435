// SPDX-License-Identifier: GPL-2.0-or-later
// The pose and the geometric Jacobian of a frame by their definitions, from the poses of all bodies.
#pragma once

#include "truth/definition/definition.hpp"

namespace flatdyn::definitions {

extern const Definition forward_kinematics, link_poses, jacobian, jacobian_dot_qd, frame_velocity, frame_acceleration,
    external_torque;

}  // namespace flatdyn::definitions
