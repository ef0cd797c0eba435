// SPDX-License-Identifier: GPL-2.0-or-later
// Places and orientations of MJCF elements: pos, and one of quat, axisangle, euler, xyaxes, zaxis.
#pragma once

#include "input/mjcf/settings.hpp"

namespace flatdyn {

// The pose that an element gives, the identity where it gives none.
Pose mjcf_pose(const MjcfItem& item, const MjcfValues& values, const MjcfSettings& settings);

// The displacements of the orientation alone.
std::vector<Displacement> mjcf_orientation(const MjcfItem& item, const MjcfValues& values,
                                           const MjcfSettings& settings);

// The rotation and the translation of a pose, in rational numbers where the file's are.
struct MjcfPlace {
  Mat3 R = identity_matrix();
  Vec3 p = zero_vector();
};
MjcfPlace exact_place(const Pose& pose);

// One pose after the other.
Pose joined(const Pose& first, const Pose& second);

Displacement translation(const Vec3& by);

// The turn by an angle, rad, about an axis that is not zero. spot, written: where the file gives it.
std::vector<Displacement> turn_about(const Vec3& axis, const Number& angle, const Spot& spot,
                                     const std::string& written, ReadContext& context);

// The turn by the smallest angle that takes z to a direction that is not zero.
std::vector<Displacement> turn_from_z(const Vec3& direction, const Spot& spot, const std::string& written,
                                      ReadContext& context);

}  // namespace flatdyn
