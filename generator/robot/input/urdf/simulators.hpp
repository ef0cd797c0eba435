// SPDX-License-Identifier: GPL-2.0-or-later
// Settings of single simulators in a URDF, in <gazebo> and <mujoco>. Most of them is about contact and drawing. What it
// says about dynamics is noted as not read; loops and springs there are refused. Mimics are read by mimics.hpp.
#pragma once

#include "robot/input/urdf/values.hpp"

namespace flatdyn {

void check_urdf_simulators(const FileNode& root, const UrdfValues& values, const Robot& robot);

}  // namespace flatdyn
