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
};

// At least two points, time strictly growing. All points have h_e, or none.
struct Trajectory {
  std::vector<TrajectoryPoint> points;

  bool has_tip_force() const { return !points.front().h_e.empty(); }
  double duration() const { return points.back().time - points.front().time; }
};

}  // namespace flatdyn
