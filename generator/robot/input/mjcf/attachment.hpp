// SPDX-License-Identifier: GPL-2.0-or-later
// The elements of another model, under names of their own: <attach>.
#pragma once

#include <array>

#include "robot/input/mjcf/element.hpp"

namespace flatdyn {

// Sections of a root that <attach> adds to, in addition to worldbody. Defaults that come along are in the last one.
inline constexpr const char* kMjcfAttachedDefaults = "attached_defaults";
inline constexpr std::array kMjcfSections = {"asset",    "tendon",   "equality",
                                             "actuator", "keyframe", kMjcfAttachedDefaults};

// Makes an <attach> a <frame> of the other model's body or frame that it names, or of all that is in its world, with
// what acts on that in the root's sections. Names of elements and classes have the prefix, as in MuJoCo. folder: of the
// other model's meshes.
void attach_mjcf(FileNode& attach, const FileNode& other, const std::string& folder, FileNode& root,
                 Diagnostics& diagnostics);

}  // namespace flatdyn
