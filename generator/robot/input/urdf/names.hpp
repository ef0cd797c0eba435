// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "robot/input/urdf/values.hpp"

namespace flatdyn {

// The names of elements and attributes that the dynamics are read from. A misspelt one would be skipped and leave
// another robot than is meant: unknown attributes of these elements, unknown elements that are called almost like one
// of them, and elements that are there twice are errors. Names with a namespace (drake:, mujoco:) belong to others.
void check_urdf_names(const FileNode& root, const UrdfValues& values);

}  // namespace flatdyn
