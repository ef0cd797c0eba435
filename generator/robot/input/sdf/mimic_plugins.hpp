// SPDX-License-Identifier: GPL-2.0-or-later
// Gazebo's plugins that let a joint follow another one.
#pragma once

#include "robot/input/sdf/tree.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

// Plugins of models in which <mimicJoint> follows <joint>: multiplier · (the position of <joint>) + offset. Plugins
// that are called mimics and say it in another way are unsupported. Joints that stand still, which an option may ask
// for, follow nothing.
void read_sdf_mimic_plugins(const SdfTree& tree, Diagnostics& diagnostics, Robot& robot);

}  // namespace flatdyn
