// SPDX-License-Identifier: GPL-2.0-or-later
// Actuators: what they add to the armature and damping of their joints and tendons, and the joints' effort limits.
#pragma once

#include "robot/input/mjcf/model.hpp"

namespace flatdyn {

void read_mjcf_actuators(MjcfModel& model);

}  // namespace flatdyn
