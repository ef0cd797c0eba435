// SPDX-License-Identifier: GPL-2.0-or-later
// TrajectoryPlan → samples of the motion, positions and derivatives by formula.
#pragma once

#include "trajectory/plan.hpp"
#include "trajectory/trajectory.hpp"

namespace flatdyn {

// At t = 0, 1 / rate, 2 / rate … and at the end; or with a point at every jump of an
// acceleration and an even number of equal intervals between, so many in all or a few more. Where an acceleration jumps
// the sample has the one that follows, the last sample the one before. What cannot be moved so (profiles that
// contradict themselves, places out of reach) goes into `diagnostics` with its line; then the result means nothing.
Trajectory planned_motion(const TrajectoryPlan& plan, const TipKinematics& tip, Diagnostics& diagnostics,
                          std::optional<int> intervals = std::nullopt);

}  // namespace flatdyn
