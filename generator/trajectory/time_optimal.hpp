// SPDX-License-Identifier: GPL-2.0-or-later
// The fastest law s(t) along a path under limits of speeds, accelerations and torques, by reachability analysis (Pham
// and Pham, A New Approach to Time-Optimal Path Parameterization Based on Reachability Analysis, 2018): on the grid of
// the trajectory's points, with x = ṡ² and u = s̈ constant between neighbours, x_{k+1} = x_k + 2 Δ_k u_k. Backwards, the
// interval of x from which the rest can be done; forwards, the largest x in it. The limits are lines in (u, x).
//
// Viscous friction is not: b √x. It is replaced by lines that bound it from the safe side and meet it at the x of the
// solution before; the first one is the linear law, which therefore is never beaten by what comes out.
#pragma once

#include <optional>

#include "trajectory/linear_scaling.hpp"

namespace flatdyn {

struct TimeLaw {
  std::vector<double> x, u;  // by point: ṡ² and, from it to the next point, s̈
  std::vector<double> time;  // s
  int rounds = 1;            // of linearising friction
};

// At least as fast as r = c t, which must keep all limits, on both sides of jumps (linear_scaling.hpp). Where the
// motion rests between two points it waits as long as it does, or c times as long if that is less. Throws
// Failure(unsupported) where nothing limits the pace.
TimeLaw time_optimal_law(const Trajectory& trajectory, const PathCoefficients& path, const PaceLimits& limits,
                         double c);

// The motion by this law at its points: rates q' √x, accelerations q' u + q'' x, and before them those by the u before.
Trajectory paced(Trajectory trajectory, const TimeLaw& law);

// Of a law made on every second point of a trajectory: the motion at the points between.
Trajectory paced_between(const Trajectory& twice_as_fine, const TimeLaw& law);

// Every second point.
Trajectory every_second(const Trajectory& trajectory);

}  // namespace flatdyn
