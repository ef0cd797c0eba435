// SPDX-License-Identifier: GPL-2.0-or-later
// Rotations of vectors about z and x, given as (cos, sin), and the cyclic permutation of axes that converts one to the
// other.
#pragma once

#include "robot/model/mechanism.hpp"

namespace flatdyn {

// Rz(a) v and Rx(a) v.
inline Vec3 rotate_z(const PlanarRotation& a, const Vec3& v) {
  return {a.c * v[0] - a.s * v[1], a.s * v[0] + a.c * v[1], v[2]};
}
inline Vec3 rotate_x(const PlanarRotation& a, const Vec3& v) {
  return {v[0], a.c * v[1] - a.s * v[2], a.s * v[1] + a.c * v[2]};
}

// The tensor with axes permuted x → y → z → x, so that a rotation about x becomes one about z. Applied twice, it is the
// inverse permutation.
inline Mat3 with_axes_cycled(const Mat3& T) {
  Mat3 result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) result[i][j] = T[(i + 1) % 3][(j + 1) % 3];
  }
  return result;
}

}  // namespace flatdyn
