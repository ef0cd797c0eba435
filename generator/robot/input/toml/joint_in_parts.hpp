// SPDX-License-Identifier: GPL-2.0-or-later
// Joints of several degrees of freedom of a [[link]]: planar, universal, cylindrical, screw.
#pragma once

#include "robot/input/toml/parts.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

bool is_joint_in_parts(const std::string& type);

// The joint as joints of one degree of freedom each, which are added to the robot, with links without mass between
// them. Friction, springs, armatures and limits are lists, one entry per coordinate; those of a screw are numbers.
// whole: with its name, parent, child and place.
void read_joint_in_parts(TomlTable& row, const std::string& type, const Joint& whole, ReadContext& context,
                         MotorCarriers& carriers, Robot& robot);

}  // namespace flatdyn
