// SPDX-License-Identifier: GPL-2.0-or-later
// A trajectory between its samples.
#pragma once

#include "trajectory/trajectory.hpp"

namespace flatdyn {

// q, qd and qdd at a time: polynomials of degree five that meet both samples' q, q̇ and q̈, so that q̈ goes on without
// jumps but where the trajectory has some. Before the first sample and after the last one the robot stands there.
// Without h_e.
TrajectoryPoint interpolated(const Trajectory& trajectory, double time);

}  // namespace flatdyn
