// SPDX-License-Identifier: GPL-2.0-or-later
// The joints of closed loops that follow from the others, where the robot's file does not name them loop by loop.
#pragma once

#include "base/diagnostics/diagnostics.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

// Fills Loop::dependent of loops that leave it to marks (Loop::is_marked). A joint marked as not independent goes to
// the loop that determines it. A loop without such joints takes as many unmarked ones as it needs: those that nothing
// drives before the others, among them those of no other loop, and of these the last in the order of q; that is noted.
// Reports as errors joints that are marked as not independent and follow from nothing, and joints that are marked as
// independent and follow from others. Loops that can only be solved together are left with too few dependent joints;
// check_loops() reports them.
void find_dependent_joints(Robot& robot, Diagnostics& diagnostics);

}  // namespace flatdyn
