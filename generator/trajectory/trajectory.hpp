// SPDX-License-Identifier: GPL-2.0-or-later
// A motion of the joints over time, and what the tip exerts meanwhile.
#pragma once

#include <vector>

namespace flatdyn {

// SI: s, rad or m and per s, s².
struct TrajectoryPoint {
  double time = 0;
  std::vector<double> q, qd, qdd;
  std::vector<double> h_e;  // force N and moment N m that the tip exerts on its environment, base axes; or empty
  // Where the acceleration jumps, qdd is the one that follows, and this the one that leads there; empty elsewhere.
  std::vector<double> qdd_before{};
};

// At least two points, time strictly growing (but with_both_sides()). All points have h_e, or none.
struct Trajectory {
  std::vector<TrajectoryPoint> points;

  bool has_tip_force() const { return !points.front().h_e.empty(); }
  double duration() const { return points.back().time - points.front().time; }
};

// Fills in qdd_before of samples that do not say it: where, of one joint, the change of q̈ from the sample before is
// large (1 % of the largest q̈), and ten times those beside it, it is a jump, and q̈ led there unchanged.
void mark_jumps(Trajectory& trajectory);

// With the other side of every jump as a point of its own, at the same time.
Trajectory with_both_sides(const Trajectory& trajectory);

}  // namespace flatdyn
