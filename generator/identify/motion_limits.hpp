// SPDX-License-Identifier: GPL-2.0-or-later
// The limits that a planned motion keeps.
#pragma once

#include <vector>

#include "model/mechanism.hpp"

namespace flatdyn {

struct JointLimits {
  double lower, upper;         // rad or m
  double speed, acceleration;  // absolute values
  double torque;               // absolute value, N m or N; infinite where the file gives none

  double middle() const { return (lower + upper) / 2; }
  double reach() const { return (upper - lower) / 2; }
};

// The file's limits. Where it gives none: ±π/2 and 2 rad/s, 10 rad/s² for a joint that turns, ±0.25 m and 0.5 m/s,
// 2 m/s² for one that slides; a joint with one end given has the other twice that far from it.
std::vector<JointLimits> motion_limits(const Mechanism& mechanism);

// What is left of them when only this part of each range, about its middle, is used.
std::vector<JointLimits> within_margin(std::vector<JointLimits> limits, double margin);

// How much of its limits a joint uses, as fractions. 1: at the limit.
struct LimitUse {
  double position = 0, speed = 0, acceleration = 0, torque = 0;
};

// Raises `use` to what this sample of the joint's motion needs.
void raise(LimitUse& use, const JointLimits& limits, double q, double qd, double qdd, double tau);

}  // namespace flatdyn
