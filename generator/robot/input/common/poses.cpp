// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/common/poses.hpp"

#include <array>
#include <utility>

#include "robot/model/rational_rotation.hpp"

namespace flatdyn {

Pose pose_from_xyz_rpy(const Vec3& xyz, const Vec3& rpy, const Place& place) {
  using Kind = Displacement::Kind;
  Pose pose{{}, place};
  if (!xyz[0].is_zero() || !xyz[1].is_zero() || !xyz[2].is_zero()) {
    pose.displacements.push_back({Kind::translation, xyz, 0});
  }
  const std::array<std::pair<Kind, Number>, 3> rotations = {
      {{Kind::rotation_z, rpy[2]}, {Kind::rotation_y, rpy[1]}, {Kind::rotation_x, rpy[0]}}};
  for (const auto& [kind, angle] : rotations) {
    if (!angle.is_zero()) pose.displacements.push_back({kind, zero_vector(), angle});
  }
  return pose;
}

ExactPlace exact_place(const Pose& pose) {
  ExactPlace place;
  for (const Displacement& each : pose.displacements) {
    if (each.kind == Displacement::Kind::translation) {
      place.p = place.p + place.R * each.translation;
    } else {
      place.R = place.R * exact_rotation(each);
    }
  }
  return {expanded(place.R), expanded(place.p)};
}

Pose joined(const Pose& first, const Pose& second) {
  Pose pose = second;
  pose.displacements.insert(pose.displacements.begin(), first.displacements.begin(), first.displacements.end());
  return pose;
}

}  // namespace flatdyn
