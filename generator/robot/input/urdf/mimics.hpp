// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <set>
#include <string>

#include "robot/input/urdf/values.hpp"

namespace flatdyn {

// Joints that follow one other joint, position = factor · position of the leader + offset, as people write that into
// URDF files: <mimic> and <drake:mimic> in a joint; Gazebo's mimic plugins, in which <mimicJoint> follows <joint>;
// <param name="mimic"> of ros2_control; <equality><joint> of an embedded <mujoco>. They become coupled joints.
// Two that say the same of a joint are fine, two that differ are an error; forms that are not known are unsupported,
// and so are those with `floating` joints, which have no single position.
void read_urdf_mimics(const FileNode& root, const std::set<std::string>& floating, const UrdfValues& values,
                      Robot& robot);

}  // namespace flatdyn
