// SPDX-License-Identifier: GPL-2.0-or-later
// Turns about z and x of vectors, as (cos, sin); and the cycle of axes that makes one of the other.
#pragma once

#include "model/mechanism.hpp"

namespace flatdyn {

// Rz(a) v and Rx(a) v.
inline Vec3 turn_z(const PlanarRotation& a, const Vec3& v) {
  return {a.c * v[0] - a.s * v[1], a.s * v[0] + a.c * v[1], v[2]};
}
inline Vec3 turn_x(const PlanarRotation& a, const Vec3& v) {
  return {v[0], a.c * v[1] - a.s * v[2], a.s * v[1] + a.c * v[2]};
}

// The turn back: Rz(back(a)) = Rz(a)ᵀ.
inline PlanarRotation back(const PlanarRotation& a) { return {a.c, -a.s}; }

// x → y → z → x, so that a turn about x is one about z of the cycled tensor. Twice is the cycle back.
inline Mat3 cycled(const Mat3& T) {
  Mat3 result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) result[i][j] = T[(i + 1) % 3][(j + 1) % 3];
  }
  return result;
}

}  // namespace flatdyn
