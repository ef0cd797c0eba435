// SPDX-License-Identifier: GPL-2.0-or-later
// The keyframe that --keyframe names.
#pragma once

#include "robot/input/mjcf/model.hpp"

namespace flatdyn {

// Takes its positions for those near which the robot's closed loops are closed. An error if there is no such keyframe,
// or if it has another count of positions than MuJoCo's q.
void read_mjcf_keyframe(const MjcfModel& model);

}  // namespace flatdyn
