// SPDX-License-Identifier: GPL-2.0-or-later
// Positions, orientations and Jacobians of a frame fixed to a body, in the base frame.
#pragma once

#include "derivation/dynamics/newton_euler.hpp"
#include "derivation/kernel/jacobian_column.hpp"

namespace flatdyn {

struct SymbolicPose {
  Mat3 R = identity_matrix();
  Vec3 p = zero_vector();
};

// The pose of a link's frame in the base frame.
SymbolicPose pose(Frames& frames, const LinkFrame& link);

// The poses of all links' frames in the base frame, from the base outwards.
std::vector<SymbolicPose> link_poses(Frames& frames);

// The position of a link's frame in the base frame, m.
Vec3 position(Frames& frames, const LinkFrame& link);

// The geometric Jacobian of a link's frame, columns J_Pi, J_Oi as in (7.18), (7.19), in the base frame; zero for joints
// that do not move it.
std::vector<JacobianColumn> jacobian(Frames& frames, const LinkFrame& link);

// J q̇: the velocity of the frame's origin, and the frame's angular velocity, in the base frame.
JacobianColumn frame_velocity(Frames& frames, const LinkFrame& link);

// J q̈ + J̇ q̇: the acceleration of the frame's origin, and the frame's angular acceleration, in the base frame.
JacobianColumn frame_acceleration(Frames& frames, const LinkFrame& link);

// J̇ q̇: the frame's acceleration while q̈ = 0 (linear, angular), in the base frame.
JacobianColumn jacobian_dot_qd(Frames& frames, const LinkFrame& link);

// A wrench given in base axes at the frame's origin, as one on its body in body axes.
Wrench wrench_on_body(Frames& frames, const LinkFrame& link, const Wrench& wrench);

}  // namespace flatdyn
