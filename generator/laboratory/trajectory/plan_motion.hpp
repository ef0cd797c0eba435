// SPDX-License-Identifier: GPL-2.0-or-later
// From TrajectoryPlan to samples of the motion; positions and derivatives come from formulas.
#pragma once

#include "laboratory/trajectory/plan.hpp"
#include "laboratory/trajectory/trajectory.hpp"

namespace flatdyn {

// Samples at t = 0, 1 / rate, 2 / rate … and at the end. With `intervals`, there are about that many instead: one
// sample at every jump of an acceleration and an even number of equal intervals between jumps. At a jump the sample has
// the acceleration that follows, at the end the one before. Moves that are impossible (contradictory profiles, places
// out of reach) are errors in `diagnostics` with their line; then the result is meaningless.
Trajectory planned_motion(const TrajectoryPlan& plan, const TipKinematics& tip, Diagnostics& diagnostics,
                          std::optional<int> intervals = std::nullopt);

}  // namespace flatdyn
