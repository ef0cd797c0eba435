// SPDX-License-Identifier: GPL-2.0-or-later
// Springs of joints, which URDF itself has no words for: attributes of a joint's <dynamics>, and Gazebo's elements in
// <gazebo reference="JOINT">.
#pragma once

#include "robot/input/urdf/values.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

// Adds the stiffness and reference of every joint's spring. Springs that are given twice in different ways are errors.
void read_urdf_springs(const FileNode& root, const UrdfValues& values, Robot& robot);

// The part of a joint's spring that an element in <gazebo> of this name gives.
enum class SpringWord { none, stiffness, reference };
SpringWord spring_word_of(std::string_view name);

}  // namespace flatdyn
