// SPDX-License-Identifier: GPL-2.0-or-later
// TrajectoryPlan → samples of the motion, positions and derivatives by formula.
#pragma once

#include "trajectory/plan.hpp"
#include "trajectory/trajectory.hpp"

namespace flatdyn {

// At t = 0, 1 / rate, 2 / rate … and at the end. Where an acceleration jumps the sample has the one that follows, the
// last sample the one before. What cannot be moved so (profiles that contradict themselves, places out of reach) goes
// into `diagnostics` with its line; then the result means nothing.
Trajectory planned_motion(const TrajectoryPlan& plan, const TipKinematics& tip, Diagnostics& diagnostics);

}  // namespace flatdyn
