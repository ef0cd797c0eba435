// SPDX-License-Identifier: GPL-2.0-or-later
// Joints by which a link moves freely: URDF's joints of type "floating", and MJCF's free joints.
#pragma once

#include <string>
#include <vector>

#include "robot/input/common/context.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

// A held joint that does not belong to the floating robot, left out with all else that stands still.
struct LeftOutJoint {
  HeldJoint held;
  JointType type;
};

// Puts in the positions of joints that are left out, where these names follow them.
void put_in_left_out(const std::vector<LeftOutJoint>& joints, ReadContext& context, Coupled& coupled);

// Makes the robot's base float if one of these joints, of type "floating", is between a root link without a body of its
// own and all that moves: the joint, that link and what stands still on it are left out, and the joint's child becomes
// the base. Other joints of that type are reported as unsupported. `joints`: indices, with places in the file. Returns
// the joints that are held and left out, whose positions are put in where joints of the robot follow them.
std::vector<LeftOutJoint> take_floating_joints(const std::vector<int>& joints, ReadContext& context, Robot& robot);

// Whether a joint of that type lets its child move relative to a link with a body, or to one that moves.
bool floats_in_tree(const Robot& robot, const Joint& joint);

// Instead of such a joint: slides along x, y and z of its frame and a spherical joint, NAME.x, NAME.y, NAME.z,
// NAME.turn, with links without mass between them.
void split_floating_joint(const std::string& name, Robot& robot);

}  // namespace flatdyn
