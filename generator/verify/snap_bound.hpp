// SPDX-License-Identifier: GPL-2.0-or-later
// A proven bound of what snapping numbers of the robot file to exact ones changes.
#pragma once

#include <optional>
#include <vector>

#include "flatdyn/reference/robot.hpp"
#include "input/common/read_options.hpp"
#include "load/loaded_robot.hpp"
#include "reference/reference_model.hpp"

namespace flatdyn {

// The largest sizes of a moving joint's position (of a prismatic joint), speed and acceleration.
struct MotionLimits {
  double position = 0, speed = 0, acceleration = 0;
};

// A bound of |τ_a - τ_b| of every joint, N m or N, at any motion within the limits, of two robots of the same structure
// whose numbers differ a little. It is an analysis of errors: beside the size of every vector of the recursive
// Newton-Euler equations goes a bound of its difference, |R_a x_a - R_b x_b| <= |R_a - R_b| |x| + |x_a - x_b| and so
// on; vectors are compared in the axes of their links. Joints must not be coupled.
double torque_difference_bound(const reference::Robot<Real50>& a, const reference::Robot<Real50>& b,
                               const std::vector<MotionLimits>& limits);

// The bound for the robot with all numbers snapped and with none. Nothing if a joint has no limits, joints are coupled,
// or the file has free symbols. `options`: those that the model was read with.
std::optional<double> snap_bound(const LoadedRobot& model, const ReadOptions& options);

}  // namespace flatdyn
