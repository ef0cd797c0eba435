// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "robot/input/urdf/values.hpp"

namespace flatdyn {

// Rotor inertias and gear ratios of a URDF's joints: <drake:rotor_inertia>, <drake:gear_ratio> in a <joint> or in the
// <actuator> or <joint> of its <transmission>, there as attributes, too; <mechanicalReduction> there, also under the
// names of ros2_control; and the attribute `armature` of <dynamics>. A rotor
// inertia adds gear_ratio^2 · rotor_inertia to b_ii only (Joint::armature); without one, gear ratios have no effect.
void read_urdf_actuators(const FileNode& root, const UrdfValues& values, Robot& robot);

// Those directly in <robot>, and those in <ros2_control>.
std::vector<const FileNode*> urdf_transmissions(const FileNode& root);

}  // namespace flatdyn
