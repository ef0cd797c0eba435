// SPDX-License-Identifier: GPL-2.0-or-later
// Masses and inertias of bodies.
#pragma once

#include "robot/input/mjcf/model.hpp"

namespace flatdyn {

// An <inertial>. frame: the frames around it, in the body's. moves: whether the body does.
Inertial mjcf_inertial(const FileNode& element, const Pose& frame, const std::string& body, bool moves,
                       const MjcfModel& model);

// Gives all bodies' links their inertia, from <inertial> or from geoms, within the bounds of <compiler>.
void add_mjcf_inertias(const MjcfModel& model);

}  // namespace flatdyn
