// SPDX-License-Identifier: GPL-2.0-or-later
// Rotations that a URDF gives by a unit quaternion: <origin quat_xyzw="0 0 0.7071068 0.7071068"/>.
#pragma once

#include "robot/model/number.hpp"

namespace flatdyn {

// x, y, z, and w, the real part.
using Quaternion = std::array<Number, 4>;

Number squared_norm(const Quaternion& q);

// roll, pitch, yaw of the rotation, for a quaternion of any length but 0: exact to many more digits than are kept of a
// rotation. Where the pitch is a quarter turn to within `tolerance`, squared, roll and yaw turn about the same axis:
// then the roll is 0.
Vec3 rpy_of(const Quaternion& q, const Number& tolerance);

// Whether two rotations are the same to within 1e-4 rad.
bool is_rotation(const Quaternion& q, const Vec3& rpy);

}  // namespace flatdyn
