// SPDX-License-Identifier: GPL-2.0-or-later
// A proven bound of how far the torques of two robots differ whose numbers differ a little.
#pragma once

#include <vector>

#include "flatdyn/reference/robot.hpp"
#include "robot/model/mechanism.hpp"
#include "truth/reference/reference_model.hpp"

namespace flatdyn {

// The largest sizes of a moving joint's position (of a prismatic joint), speed and acceleration.
struct MotionLimits {
  double position = 0, speed = 0, acceleration = 0;
};

// The limits of every moving joint (robot/model/states.hpp: MotionRange), in the order of q.
std::vector<MotionLimits> largest_motion(const Mechanism& mechanism);

// The largest lengths of ω, ω̇ and v̇ + ω × v of the base; zeros if it is fixed.
struct MotionOfBase {
  double omega = 0, domega = 0, ddp = 0;
};
MotionOfBase largest_motion_of_base(const Mechanism& mechanism);

// A bound of |τ_a - τ_b| of every joint, N m or N, and of the force and the moment on a floating base, at any motion
// within the limits, of two robots of the same structure whose numbers differ a little. It is an analysis of errors:
// every vector of the recursive Newton-Euler equations has a bound of its size and one of its difference, |R_a x_a -
// R_b x_b| <= |R_a - R_b| |x| + |x_a - x_b| and so on; vectors are compared in the axes of their links. Joints must not
// be coupled.
double torque_difference_bound(const reference::Robot<Real50>& a, const reference::Robot<Real50>& b,
                               const std::vector<MotionLimits>& limits, const MotionOfBase& base = {});

}  // namespace flatdyn
