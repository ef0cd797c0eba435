// SPDX-License-Identifier: GPL-2.0-or-later
// A joint of several degrees of freedom as joints of one each, one behind the other, with links without mass between
// them. Its parts are called after it, in the order of its coordinates: "arm.axis", "arm.axis2".
#pragma once

#include <array>

#include "robot/input/common/context.hpp"

namespace flatdyn {

// A part that carries the name, the place and the axis of the whole joint.
Joint part_of_joint(const Joint& whole, const std::string& ending, JointType type);

// NAME.x, NAME.y, NAME.turn: along x and y of the plane that the joint's axis is perpendicular to, then about that
// axis. x and y are those of the joint's frame, turned by the smallest angle that takes its z axis to the joint's.
// `what` names the joint's axis in messages. The axis must not be zero.
std::vector<Joint> planar_parts(const Joint& whole, const std::string& what, ReadContext& context);

// NAME turns about the axis; NAME.slide follows it along the axis, m per rad.
std::vector<Joint> screw_parts(const Joint& whole, const Number& travel);

// The parts with their places in the tree: the first one hangs on the whole joint's parent, the last one carries its
// child. The links between, NAME.between, NAME.between2, are added to the robot.
std::vector<Joint> joined_in_tree(const Joint& whole, std::vector<Joint> parts, Robot& robot);

// Options that hold the whole joint at 0 then hold its parts.
void hold_parts(const std::string& whole, const std::vector<Joint>& parts, ReadContext& context);

}  // namespace flatdyn
