// SPDX-License-Identifier: GPL-2.0-or-later
// A floating base: the root link moves freely, and its inertia counts.
//
// State: the base twist ν_b = (v, ω): the velocity of the base frame's origin, m/s, then the angular velocity, rad/s,
// both in base axes. Accelerations are the derivatives of these components: (v̇, ω̇). Generalised forces are (f, n):
// the force, N, and the moment about the base frame's origin, N m, in base axes. They are the first six entries of q̇,
// q̈ and τ; the joints follow. What depends on the base's orientation depends on g_b, gravity in base axes.
//
// In the mechanism the base's motion is a chain of six bodies: it slides along x, y and z, then it turns about x, y and
// z. These are coordinates x around the present pose, where they are all zero, with ν = A(x) ẋ and A(0) = 1. So
// Lagrange's equations hold in them, with ẍ = ν̇ - Ȧ ν at zero, and their generalised forces are (f, n). Bodies 0 to 4
// have no inertia; body 5 is the base link, in the base frame.
#pragma once

#include <vector>

#include "robot/model/field_vector.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

// Lets the base of a mechanism whose base is fixed move freely, within the limits if there are any.
Mechanism with_floating_base(Mechanism mechanism, const std::optional<BaseLimits>& limits = std::nullopt);

// The base of this mechanism, which floats, has the armature and friction of the joint. They are those of bodies 0 to
// 5, in the entries of ν: the armature of the turns belongs to ω, and so is an inertia of the base link that is alike
// about all axes; that of the slides is a mass at the base frame's origin that nothing attracts.
Mechanism with_base_joint(Mechanism mechanism, const BaseJoint& joint);

// Whether the base of a mechanism floats and has armature or friction of its own.
bool has_base_joint(const Mechanism& mechanism);
bool has_base_armature(const Mechanism& mechanism);
bool has_base_friction(const Mechanism& mechanism);

// The same mechanism with a base on which only forces from outside act.
Mechanism without_base_joint(Mechanism mechanism);

// The Coriolis-like part of ẍ = ν̇ - Ȧ ν: -Ȧ ν for a twist of six entries, (v, ω), over any scalar.
//     -Ȧ ν = (ω × v, (-ω_y ω_z, ω_x ω_z, -ω_x ω_y))
template <class S>
std::vector<S> base_drift(const std::vector<S>& twist) {
  const S &vx = twist[0], &vy = twist[1], &vz = twist[2], &wx = twist[3], &wy = twist[4], &wz = twist[5];
  return {wy * vz - wz * vy, wz * vx - wx * vz, wx * vy - wy * vx, -(wy * wz), wx * wz, -(wx * wy)};
}

// Entry (i, j) of Ȧ at zero for ẋ = ν, 6 × 6: C = C_x - B Ȧ is the matrix in these velocities of which Ḃ - 2 C is
// skew-symmetric, if C_x is that of the Christoffel symbols of x, (7.44).
template <class S>
std::vector<std::vector<S>> base_rate_matrix(const std::vector<S>& twist) {
  const S &wx = twist[3], &wy = twist[4], &wz = twist[5], zero = S(0);
  return {{zero, wz, -wy, zero, zero, zero},  {-wz, zero, wx, zero, zero, zero},   {wy, -wx, zero, zero, zero, zero},
          {zero, zero, zero, zero, wz, zero}, {zero, zero, zero, -wz, zero, zero}, {zero, zero, zero, wy, zero, zero}};
}

}  // namespace flatdyn
