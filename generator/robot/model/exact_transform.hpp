// SPDX-License-Identifier: GPL-2.0-or-later
// Poses in exact numbers, and rotations without what rounding has left of zeros.
#pragma once

#include "robot/model/rational_rotation.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

// A point at x in the frame is at R x + p, p in m.
struct Transform {
  Mat3 R = identity_matrix();
  Vec3 p = zero_vector();
};

// b in the frame of a.
Transform compose(const Transform& a, const Transform& b);

// The pose with its numbers made rational.
Transform exact_transform(const Pose& pose);

// The rotation by the ZXZ angles of R, which are made rational again. So the frames that it places, and the distances
// to axes, are exactly zero where they have to be.
Mat3 from_zxz(const Mat3& R);

// A rotation in which entries that are 0 or 1 up to a rounding residue are exactly 0 or 1.
Mat3 snap_residues_to_zero(const Mat3& R);

}  // namespace flatdyn
