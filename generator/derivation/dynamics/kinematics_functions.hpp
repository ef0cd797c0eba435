// SPDX-License-Identifier: GPL-2.0-or-later
// Kinematics of the frame of a link, or of the tip, as functions.
#pragma once

#include "derivation/dynamics/derivation_context.hpp"

namespace flatdyn {

Function derive_forward_kinematics(const Mechanism& mechanism, const LinkFrame& link);
Function derive_link_poses(const Mechanism& mechanism);
Function derive_jacobian(const Mechanism& mechanism, const LinkFrame& link);
Function derive_jacobian_dot_qd(const Mechanism& mechanism, const LinkFrame& link);
Function derive_frame_velocity(const Mechanism& mechanism, const LinkFrame& link);
Function derive_frame_acceleration(const Mechanism& mechanism, const LinkFrame& link);

}  // namespace flatdyn
