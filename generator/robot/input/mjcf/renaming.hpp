// SPDX-License-Identifier: GPL-2.0-or-later
// Names of MJCF elements and the attributes that refer to them, which copies and attached models have anew.
#pragma once

#include <functional>
#include <map>
#include <set>

#include "robot/input/mjcf/element.hpp"

namespace flatdyn {

// Names by what they are of: "body", "joint", "site", "geom", "tendon".
using MjcfNames = std::map<std::string, std::set<std::string>>;

// The names of all elements in one. Free joints are joints.
MjcfNames mjcf_names_in(const FileNode& element);

// The kind of what an attribute refers to: "joint" of joint1; "" of one that names nothing of the above.
std::string mjcf_reference_kind(const std::string& attribute);

// How many of these names an element of <equality>, <tendon> or <actuator> refers to, and how many others.
struct MjcfReferences {
  int inside = 0, outside = 0;
};
MjcfReferences mjcf_references(const FileNode& element, const MjcfNames& names);

using MjcfRenaming = std::function<std::string(const std::string&)>;

// Renames elements, the element itself and all in it. references: also what it refers to, other than the world.
void rename_mjcf(FileNode& element, const MjcfRenaming& renaming, bool references);

}  // namespace flatdyn
