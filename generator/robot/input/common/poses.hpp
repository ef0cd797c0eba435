// SPDX-License-Identifier: GPL-2.0-or-later
// Poses as displacements, one after the other.
#pragma once

#include "robot/model/robot.hpp"

namespace flatdyn {

// The displacements of xyz and rpy, the translation and then Rz(yaw) Ry(pitch) Rx(roll); zero ones are left out.
Pose pose_from_xyz_rpy(const Vec3& xyz, const Vec3& rpy, const Place& place);

// The rotation and the translation of a pose, in rational numbers where the file's are.
struct ExactPlace {
  Mat3 R = identity_matrix();
  Vec3 p = zero_vector();
};
ExactPlace exact_place(const Pose& pose);

// One pose after the other.
Pose joined(const Pose& first, const Pose& second);

}  // namespace flatdyn
