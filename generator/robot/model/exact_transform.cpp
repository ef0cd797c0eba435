// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/exact_transform.hpp"

#include "robot/model/angles.hpp"

namespace flatdyn {
namespace {

Transform exact_transform(const Displacement& displacement) {
  return {exact_rotation(displacement), rationalised(displacement.translation)};
}

Mat3 rotation_by(const ZxzAngles& angles) {
  return expanded(rotation_z(angles.beta) * rotation_x(angles.alpha) * rotation_z(angles.theta));
}

}  // namespace

Transform compose(const Transform& a, const Transform& b) { return {expanded(a.R * b.R), expanded(a.p + a.R * b.p)}; }

Transform exact_transform(const Pose& pose) {
  Transform result;
  for (const Displacement& displacement : pose.displacements) result = compose(result, exact_transform(displacement));
  return result;
}

Mat3 from_zxz(const Mat3& R) { return rotation_by(zxz_angles(R)); }

Mat3 snap_residues_to_zero(const Mat3& R) {
  for (const Vec3& row : R) {
    const Vec3 cleared = snap_residue_to_zero(row, 1);
    if (row[0].is_equal(cleared[0]) && row[1].is_equal(cleared[1]) && row[2].is_equal(cleared[2])) continue;
    return rotation_by(zxz_angles(R));
  }
  return R;
}

}  // namespace flatdyn
