// SPDX-License-Identifier: GPL-2.0-or-later
// The pose and the geometric Jacobian of the tip by the reference.
#pragma once

#include "truth/reference/numeric_reference.hpp"

namespace flatdyn::references {

extern const NumericReference forward_kinematics, link_poses, jacobian, jacobian_dot_qd, frame_velocity,
    frame_acceleration, external_torque;

}  // namespace flatdyn::references
