// SPDX-License-Identifier: GPL-2.0-or-later
// Dynamic scaling of trajectories by the linear law r(t) = c t, 7.7: the whole motion takes c times as long. With
// u = 1/c rates scale by u, accelerations by u², and (path_torques.hpp)
//   τ = a u² + b u + d,
// of which every limit forbids intervals of u: the largest u outside of all is exact, friction included.
#pragma once

#include <optional>

#include "trajectory/pace_limits.hpp"
#include "trajectory/path_torques.hpp"

namespace flatdyn {

struct LinearScaling {
  double c = 1;
  std::optional<LimitUsed> decided_by;  // the limit that a smaller c would exceed; none where c is the least allowed
};

// The smallest c ≥ least_c > 0 that keeps all limits at all points; nullopt if there is none: what does not change with
// the pace is too much for a limit.
std::optional<LinearScaling> linear_scaling(const Trajectory& trajectory, const PathCoefficients& path,
                                            const PaceLimits& limits, double least_c);

// Where |d| is largest, as a part of the torque limit.
LimitUsed most_static_load(const PathCoefficients& path, const PaceLimits& limits);

// c times as long.
Trajectory slowed(Trajectory trajectory, double c);

}  // namespace flatdyn
