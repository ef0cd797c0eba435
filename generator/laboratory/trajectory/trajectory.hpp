// SPDX-License-Identifier: GPL-2.0-or-later
// A motion of the joints over time, with the force that the tip exerts.
#pragma once

#include <vector>

namespace flatdyn {

// A sample in SI units: s; rad or m, and their derivatives by time.
struct TrajectoryPoint {
  double time = 0;
  std::vector<double> q, qd, qdd;
  std::vector<double> h_e;  // force, N, and moment, N m, that the tip exerts on its environment, base axes; or empty
  // The acceleration just before a jump, where qdd is the one just after; empty where there is no jump.
  std::vector<double> qdd_before{};
};

// At least two points with strictly increasing time (except after with_both_sides()). All points have h_e, or none.
struct Trajectory {
  std::vector<TrajectoryPoint> points;

  bool has_tip_force() const { return !points.front().h_e.empty(); }
  double duration() const { return points.back().time - points.front().time; }
};

// Fills in qdd_before where samples lack it. A jump is where the change of a joint's q̈ from the sample before is
// large, more than 1 % of the largest q̈ and ten times the neighbouring changes; q̈ before it is that of the sample
// before.
void mark_jumps(Trajectory& trajectory);

// The trajectory with a second point, at the same time, for the other side of every jump.
Trajectory with_both_sides(const Trajectory& trajectory);

}  // namespace flatdyn
