// SPDX-License-Identifier: GPL-2.0-or-later
// The limits of speed, acceleration and torque: absolute values, one per joint, infinite where there is none.
#pragma once

#include <vector>

#include "laboratory/trajectory/trajectory.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

enum class LimitKind { speed, acceleration, torque };

struct PaceLimits {
  std::vector<double> speed, acceleration, torque;  // rad/s, rad/s², N m, or m/s, m/s², N

  bool are_infinite() const;
};

// The limits of the robot file and the scene.
PaceLimits given_limits(const Mechanism& mechanism);

// The largest use of a limit, as a share of it, and where it occurs; the share is 0 without limits.
struct LargestLimitUse {
  double part = 0;
  LimitKind kind = LimitKind::torque;
  std::size_t joint = 0, point = 0;
};
// The largest use by the trajectory with torques tau by point, N m or N.
LargestLimitUse largest_limit_use(const Trajectory& trajectory, const std::vector<std::vector<double>>& tau,
                                  const PaceLimits& limits);

}  // namespace flatdyn
