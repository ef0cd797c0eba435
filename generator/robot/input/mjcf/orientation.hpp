// SPDX-License-Identifier: GPL-2.0-or-later
// Places and orientations of MJCF elements: pos, and one of quat, axisangle, euler, xyaxes, zaxis.
#pragma once

#include "robot/input/common/poses.hpp"
#include "robot/input/common/turns.hpp"
#include "robot/input/mjcf/settings.hpp"

namespace flatdyn {

// The pose that an element gives, the identity where it gives none.
Pose mjcf_pose(const MjcfItem& item, const MjcfValues& values, const MjcfSettings& settings);

// The displacements of the orientation alone.
std::vector<Displacement> mjcf_orientation(const MjcfItem& item, const MjcfValues& values,
                                           const MjcfSettings& settings);

}  // namespace flatdyn
