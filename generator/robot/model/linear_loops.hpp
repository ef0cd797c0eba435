// SPDX-License-Identifier: GPL-2.0-or-later
// Closed chains in which the dependent joints are linear in the others: parallelograms, and chains of them, (7.3.3).
#pragma once

#include "base/diagnostics/diagnostics.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

// Finds q = A q_a + b of each loop's dependent joints, and couples them so. Factors -1, 0, 1 and quarter turns are
// tried, and kept if the loop stays closed for all positions and all values of symbols: decided modulo a large prime at
// random points. These loops are done with then; others stay, and are checked, see loop_closure.hpp. For a robot that
// has been validated.
void couple_linear_loops(Robot& robot, Diagnostics& diagnostics);

}  // namespace flatdyn
