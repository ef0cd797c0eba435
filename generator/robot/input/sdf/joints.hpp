// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <vector>

#include "robot/input/sdf/tree.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

// Adds the joints of a placed tree to a robot that has its links. A joint with two axes becomes two joints, NAME.axis
// and NAME.axis2, with a link NAME.between that has no mass. `links`: by frame, the index of its link, -1 of others.
void read_sdf_joints(const SdfTree& tree, std::vector<int> links, ReadContext& context, Robot& robot);

}  // namespace flatdyn
