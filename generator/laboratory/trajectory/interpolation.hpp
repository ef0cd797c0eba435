// SPDX-License-Identifier: GPL-2.0-or-later
// Interpolation between the samples of a trajectory.
#pragma once

#include "laboratory/trajectory/trajectory.hpp"

namespace flatdyn {

// q, qd and qdd at a time in s: polynomials of degree five that meet q, q̇ and q̈ of both samples, so that q̈ is
// continuous except where the trajectory has a jump. Before the first sample and after the last one the robot stands
// still there. The result has no h_e.
TrajectoryPoint interpolated(const Trajectory& trajectory, double time);

}  // namespace flatdyn
