// SPDX-License-Identifier: GPL-2.0-or-later
// The limits that a planned motion keeps.
#pragma once

#include <vector>

#include "robot/model/mechanism.hpp"

namespace flatdyn {

// The limits of one coordinate of a motion, in rad or m and seconds.
struct JointLimits {
  double lower, upper;         // rad or m
  double speed, acceleration;  // absolute values
  double torque;               // absolute value, N m or N; infinite if the file gives none

  double middle() const { return (lower + upper) / 2; }
  double reach() const { return (upper - lower) / 2; }
};

// The limits of the file. Defaults for a revolute joint are ±π/2, 2 rad/s and 10 rad/s², for a prismatic joint ±0.25 m,
// 0.5 m/s and 2 m/s², for roll, pitch and yaw of a spherical joint ±0.8 rad, 2 rad/s and 10 rad/s². A joint with only
// one end given has the other twice that far from it. A floating base comes first: ±0.1 m, 0.25 m/s and 1 m/s², ±0.4
// rad, 1 rad/s and 5 rad/s², unless the scene's [base_limits] say other rates.
std::vector<JointLimits> motion_limits(const Mechanism& mechanism);

// The limits reduced to the share `margin` of each range, about its middle.
std::vector<JointLimits> within_margin(std::vector<JointLimits> limits, double margin);

// The share of its limits that a joint uses; 1 is at the limit.
struct LimitUse {
  double position = 0, speed = 0, acceleration = 0, torque = 0;
};

// Raises `use` to what this sample needs: q, qd, qdd in rad or m and seconds, tau in N m or N.
void update_use(LimitUse& use, const JointLimits& limits, double q, double qd, double qdd, double tau);

}  // namespace flatdyn
