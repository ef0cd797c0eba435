// SPDX-License-Identifier: GPL-2.0-or-later
// Elements of a URDF that have nothing but what is known of them.
#pragma once

#include <string>
#include <vector>

#include "robot/input/urdf/values.hpp"

namespace flatdyn {

// An error for each attribute of the element that is not one of these.
void refuse_other_attributes(const FileNode& element, const std::string& what, const std::vector<std::string>& known,
                             const UrdfValues& values);

// An error for each child of the element that is not one of these, and for a text in it.
void refuse_children(const FileNode& element, const std::string& what, const std::vector<std::string>& known,
                     const UrdfValues& values);

// An error for the second child of this name.
void refuse_second(const FileNode& element, const std::string& what, const std::string& tag, const UrdfValues& values);

}  // namespace flatdyn
