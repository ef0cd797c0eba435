// SPDX-License-Identifier: GPL-2.0-or-later
// Which joints of closed loops follow from the others, where the robot's file does not say it loop by loop.
#pragma once

#include "diagnostics/diagnostics.hpp"
#include "model/robot.hpp"

namespace flatdyn {

// Fills Loop::dependent of loops that leave it to marks (Loop::is_marked). Of joints that are marked as not
// independent, each goes to the loop that it determines. A loop without such joints takes as many as it needs that are
// not marked, those that no other loop has before others, and of them the last ones in the order of q; that is noted.
// Joints that are marked as not independent and follow from nothing, or as independent and follow others, are errors.
// Loops that can only be solved together are left without some of theirs, and are reported by check_loops().
void find_dependent_joints(Robot& robot, Diagnostics& diagnostics);

}  // namespace flatdyn
