// SPDX-License-Identifier: GPL-2.0-or-later
// Dynamic scaling of trajectories by the linear law r(t) = c t, 7.7: the whole motion takes c times as long. With u =
// 1/c rates scale by u, accelerations by u², and (path_torques.hpp)
//   τ = a u² + b u + d,
// so every limit forbids intervals of u. The largest u outside all of them is exact, friction included.
#pragma once

#include <optional>

#include "laboratory/trajectory/pace_limits.hpp"
#include "laboratory/trajectory/path_torques.hpp"

namespace flatdyn {

struct LinearScaling {
  double c = 1;
  std::optional<LargestLimitUse> decided_by;  // the limit that a smaller c would exceed; none if c is the least allowed
};

// The smallest c ≥ least_c > 0 that keeps all limits at all points; nullopt if there is none because torques that do
// not change with the pace exceed a limit.
std::optional<LinearScaling> linear_scaling(const Trajectory& trajectory, const PathCoefficients& path,
                                            const PaceLimits& limits, double least_c);

// The largest |d| as a share of its torque limit, and where it occurs.
LargestLimitUse largest_static_load(const PathCoefficients& path, const PaceLimits& limits);

// The trajectory, made c times as long.
Trajectory slowed(Trajectory trajectory, double c);

}  // namespace flatdyn
