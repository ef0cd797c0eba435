// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "robot/input/urdf/values.hpp"

namespace flatdyn {

// Closed chains: URDF+'s <loop>, with <predecessor> and <successor>, each with an <origin>, and an <axis> in both;
// <constraint>, with the same or with <parent>, <parent_origin>, <parent_axis>, <child> and so on; <loop_constraint>, a
// ball joint; <equality><connect> of an embedded <mujoco>, closed where the joints are at 0. Types: a point on a point
// (spherical, ball, position), an axis on an axis (revolute, continuous). Others are unsupported. Which joints follow
// from the others is found from their marks, see robot/model/dependent_joints.hpp.
void read_urdf_loops(const FileNode& root, const UrdfValues& values, Robot& robot);

}  // namespace flatdyn
