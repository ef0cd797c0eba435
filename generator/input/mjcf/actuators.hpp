// SPDX-License-Identifier: GPL-2.0-or-later
// Actuators: what they add to their joints' armature and damping, and the joints' effort limits.
#pragma once

#include "input/mjcf/model.hpp"

namespace flatdyn {

void read_mjcf_actuators(const MjcfModel& model);

// Tendons that pull, or through which actuators act, are refused; so is what bends.
void refuse_mjcf_tendons(const MjcfModel& model);

}  // namespace flatdyn
