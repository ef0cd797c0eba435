// SPDX-License-Identifier: GPL-2.0-or-later
// The fastest law s(t) along a path under limits of speeds, accelerations and torques, by reachability analysis (Pham
// and Pham, A New Approach to Time-Optimal Path Parameterization Based on Reachability Analysis, 2018): on the grid of
// the trajectory's points, with x = ṡ² and u = s̈ constant between neighbours, x_{k+1} = x_k + 2 Δ_k u_k. A backward
// pass finds the interval of x from which the rest can be completed, a forward pass the largest x in it. The limits are
// lines in (u, x).
//
// Viscous friction b √x is not linear. It is replaced by lines that bound it from the safe side and touch it at the x
// of the previous solution. The first of these is the linear law, so the result is never slower than that.
#pragma once

#include <optional>

#include "laboratory/trajectory/linear_scaling.hpp"

namespace flatdyn {

struct TimeLaw {
  std::vector<double> x, u;  // by point: ṡ², and s̈ from it to the next point
  std::vector<double> time;  // s
  int rounds = 1;            // rounds of linearising friction
};

// A law at least as fast as r = c t, which must keep all limits on both sides of jumps (linear_scaling.hpp). A rest
// between two points lasts as long as given, or c times as long if that is less. Throws Failure(unsupported) if nothing
// limits the pace.
TimeLaw time_optimal_law(const Trajectory& trajectory, const PathCoefficients& path, const PaceLimits& limits,
                         double c);

// The motion by this law at its points: rates q' √x, accelerations q' u + q'' x; before a jump those with the previous
// u.
Trajectory paced(const Trajectory& trajectory, const TimeLaw& law);

// The motion at the points of a twice as fine trajectory, by a law made on every second point of it.
Trajectory paced_between(const Trajectory& twice_as_fine, const TimeLaw& law);

// Every second point.
Trajectory every_second(const Trajectory& trajectory);

}  // namespace flatdyn
