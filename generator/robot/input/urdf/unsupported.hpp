// SPDX-License-Identifier: GPL-2.0-or-later
// Elements that change the dynamics and are not read: constraints, springs, cables, rotors in ros2_control. They are
// refused, never skipped.
#pragma once

#include <string_view>

#include "robot/input/urdf/values.hpp"

namespace flatdyn {

void refuse_unread_dynamics(const FileNode& root, const UrdfValues& values, const Robot& robot);

inline constexpr const char* kLoopHint =
    "write it as <loop name=\"...\" type=\"revolute\"> with <predecessor link=\"...\">, <successor link=\"...\">, an "
    "<origin> in each, and <axis>";

// `where` follows the element's name in the message: " in <gazebo>".
void refuse_unsupported(const FileNode& element, const std::string& where, const char* hint, const UrdfValues& values);

// A joint of this name that does not move: a spring there does nothing.
bool is_at_rest(const Robot& robot, const std::string& joint);

}  // namespace flatdyn
