// SPDX-License-Identifier: GPL-2.0-or-later
// Gearboxes of SDF models: they couple two joints of one body by a ratio.
#pragma once

#include "robot/input/sdf/tree.hpp"

namespace flatdyn {

// gearbox: its frame. The joint between the reference body and the gearbox's child then follows the one between the
// reference body and its parent: their angles about <axis2> and <axis> are theta_2 = -gearbox_ratio theta_1. Other
// gearboxes are refused. links: of the robot, by frame. The robot has all other joints already.
void read_sdf_gearbox(const SdfTree& tree, int gearbox, const std::vector<int>& links, ReadContext& context,
                      Robot& robot);

}  // namespace flatdyn
