// SPDX-License-Identifier: GPL-2.0-or-later
// The motion of a mechanism's bodies in the form that a regressor needs. Terms quadratic in the joint rates are kept as
// a symmetric bilinear form of two rates, q̇ and a reference q̇_r. So B q̈_r + C(q, q̇) q̇_r has the C of the
// Christoffel symbols, (7.44), because they are symmetric: c_ijk = c_ikj. With q̇_r = q̇ it is the motion itself. For
// velocities of floating bases and spherical joints, C is as said in robot/model/quasi_velocities.hpp.
#pragma once

#include <vector>

#include "derivation/kernel/frames.hpp"

namespace flatdyn {

struct JointMotion {
  std::vector<Number> qd, qd_r, qdd_r;  // of a floating base, v and a before those of joints
  Vec3 gravity = zero_vector();         // in the base frame, m/s^2
};

// The motion of a body, in its own frame. A point at x in that frame has the acceleration less gravity ddp + U x.
struct BodyMotion {
  Vec3 omega = zero_vector(), omega_r = zero_vector();  // for q̇ and for q̇_r, rad/s
  Vec3 domega = zero_vector();                          // rad/s^2
  Vec3 ddp = zero_vector();                             // acceleration of the frame's origin less gravity, m/s^2
  Mat3 products = zero_matrix();                        // ω ωᵀ, as the symmetric part of ω ω_rᵀ
  Mat3 U = zero_matrix();                               // S(ω̇) + ω ωᵀ - (ω·ω) 1, 1/s^2
};

// The motions of all bodies. With a floating base, whose motion is one of its link, bodies before it have none, nor
// have the first two bodies of a spherical joint.
std::vector<BodyMotion> body_motions(Frames& frames, const JointMotion& motion);

// q̇_i ω of a body, as a bilinear form: ½ (q̇_i ω_r + q̇_ri ω).
Vec3 rate_times_omega(const JointMotion& motion, int i, const Vec3& omega, const Vec3& omega_r);

}  // namespace flatdyn
