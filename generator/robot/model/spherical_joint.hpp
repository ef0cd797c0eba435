// SPDX-License-Identifier: GPL-2.0-or-later
// Spherical joints (ball joints) inside a tree.
//
// q has four entries of such a joint: a unit quaternion (w, x, y, z) that turns the child's axes into the parent's,
// both those of the joint. q̇ has three: the angular velocity of the child relative to the parent in the child's axes,
// rad/s; q̈ has the derivatives of these components, and τ the moment on the child in its axes, N m.
//
// In a mechanism the joint is a chain of three bodies at one point: the first turns about x of the joint, the second
// about y, the last about z. These are coordinates x around the present pose, where they are all zero, with ω = A(x) ẋ
// and A(0) = 1, as those of a floating base (robot/model/floating_base.hpp). So Lagrange's equations hold in them, with
// ẍ = ω̇ - Ȧ ω at zero, and their generalised forces are the moment. Only the last body has inertia, and its axes are
// those of the joint's child. The quaternion's rotation R comes before the first body's: its frame in its parent's is
// p, then Rz(beta) Rx(alpha) Rz(theta), R, and a constant rotation that puts z on x, so that the rows of R are only
// written in another order.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "robot/model/mechanism.hpp"

namespace flatdyn {

inline constexpr int kSphericalBodies = 3;

// R with its columns y, z, x: R times the rotation that puts z on x, x on y and y on z.
template <class Matrix>
Matrix with_columns_cycled(const Matrix& R) {
  Matrix result = R;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) result[i][j] = R[i][(j + 1) % 3];
  }
  return result;
}

// The three bodies of a spherical joint, alike but for their names, "JOINT.wx" to "JOINT.wz": `last` has the joint's
// name and all properties, with the place of the joint's frame in the parent's.
std::array<Body, kSphericalBodies> bodies_of_spherical_joint(const Body& last);

// The first body of the joint that moves body i: two before it for the last one of a spherical joint.
inline int first_body_of_joint(const Mechanism& mechanism, int i) {
  const int part = mechanism.bodies[static_cast<std::size_t>(i)].spherical;
  return part == 0 ? i : i + 1 - part;
}

// The body that the joint of body i is on, -1 for a fixed base.
inline int parent_of_joint(const Mechanism& mechanism, int i) {
  return mechanism.bodies[static_cast<std::size_t>(first_body_of_joint(mechanism, i))].parent;
}

// Whether it is the first or second body of a spherical joint, which have no inertia and are no links.
inline bool is_inside_joint(const Body& body) { return body.spherical > 0 && body.spherical < kSphericalBodies; }

// Whether the body stands for a motion only, and has no inertial parameters.
inline bool has_no_link(const Body& body) { return is_inside_joint(body) || body.is_tendon; }

// The joint's name from that of one of its bodies: "JOINT".
std::string spherical_joint_name(const std::string& body);
// The name of the joint that moves a body, as written.
inline std::string joint_name(const Body& body) {
  return body.spherical > 0 ? spherical_joint_name(body.joint) : body.joint;
}

// The rotation of a unit quaternion (w, x, y, z), over any scalar:
//     1 + 2 w S(r) + 2 S(r)², r = (x, y, z).
// It takes the fewest operations. For |q|² = 1 + ε it is R + ε (R - 1) with R that of q / |q|: an error of 2 |ε| at
// most, as the norm of a matrix.
template <class S>
std::array<std::array<S, 3>, 3> rotation_of_quaternion(const std::array<S, 4>& q) {
  const S &w = q[0], &x = q[1], &y = q[2], &z = q[3], one = S(1);
  const auto twice = [](const S& a) -> S { return a + a; };
  return {{{one + -twice(y * y + z * z), twice(x * y + -(w * z)), twice(x * z + w * y)},
           {twice(x * y + w * z), one + -twice(x * x + z * z), twice(y * z + -(w * x))},
           {twice(x * z + -(w * y)), twice(y * z + w * x), one + -twice(x * x + y * y)}}};
}

// -Ȧ ω of ẍ = ω̇ - Ȧ ω: (-ω_y ω_z, ω_x ω_z, -ω_x ω_y).
template <class S>
std::array<S, 3> spherical_drift(const S& wx, const S& wy, const S& wz) {
  return {-(wy * wz), wx * wz, -(wx * wy)};
}

// Ȧ at zero for ẋ = ω, on which ω_x has no effect: C = C_x - B Ȧ is the matrix in these velocities of which Ḃ - 2 C is
// skew-symmetric.
template <class S>
std::array<std::array<S, 3>, 3> spherical_rate_matrix(const S& wy, const S& wz) {
  const S zero = S(0);
  return {{{zero, wz, zero}, {-wz, zero, zero}, {wy, zero, zero}}};
}

}  // namespace flatdyn
