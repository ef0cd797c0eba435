// SPDX-License-Identifier: GPL-2.0-or-later
// The tree of bodies in <worldbody>.
#pragma once

#include "robot/input/mjcf/model.hpp"

namespace flatdyn {

// Reads bodies, joints and sites into the model and the robot; geoms are kept for inertia.
void read_mjcf_bodies(MjcfModel& model);

}  // namespace flatdyn
