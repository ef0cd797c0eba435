// SPDX-License-Identifier: GPL-2.0-or-later
// Names in MJCF files: which elements and attributes there are, and which change the dynamics without being read.
#pragma once

#include "robot/input/mjcf/values.hpp"

namespace flatdyn {

// Errors for elements and attributes that MJCF does not have where they are: a misspelt one would leave another robot
// than is meant. Sections that have nothing to do with dynamics are not looked into.
void check_mjcf_names(const FileNode& root, Diagnostics& diagnostics);

// Something that changes the dynamics and is not read. name: what --ignore leaves out.
void refuse_mjcf(const Place& place, const std::string& message, const std::string& name, const MjcfValues& values);

}  // namespace flatdyn
