// SPDX-License-Identifier: GPL-2.0-or-later
// Joints that are held still: --fix, `fixed` of TOML robot files, [locked] of scenes.
#pragma once

#include <string>
#include <vector>

#include "robot/input/toml/table.hpp"

namespace flatdyn {

// JOINT = POSITION, ... of a table.
std::vector<JointPosition> read_locked(TomlTable table);

// The position, in rad or m, of a joint that is not held. It is asked about where it is odd.
Number assembled(const HeldJoint& written, const Joint& joint, const Spot& spot, ReadContext& context);

// Makes fixed joints of context.held_joints. The rotor of one that no longer turns becomes a body of its carrier.
void hold_joints(ReadContext& context, Robot& robot);

}  // namespace flatdyn
