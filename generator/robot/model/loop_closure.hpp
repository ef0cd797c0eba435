// SPDX-License-Identifier: GPL-2.0-or-later
// Closed loops in general: four-bar linkages, slider-cranks and whatever else a cut joint closes. q has the positions
// of all joints; those that depend on others are found from the closure Φ(q) = 0, and q̇ from Φ_q q̇ = 0.
#pragma once

#include <vector>

#include "base/diagnostics/diagnostics.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

// Adds the robot's loops to its tree. They must be loops that check_loops() has found right.
void add_loops(const Robot& robot, Mechanism& tree);

// Loops determine as many joints as they name, each one those that no loop before it does. Decided in 50 digits at one
// position. `tree`: without loops.
void check_loops(const Robot& robot, const Mechanism& tree, Diagnostics& diagnostics);

// Whether one of its loops has equations of axes.
bool aligns_axes(const Mechanism& mechanism);

}  // namespace flatdyn
