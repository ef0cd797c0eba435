// SPDX-License-Identifier: GPL-2.0-or-later
// A motion that keeps the limits, and what it tells of the parameters.
#pragma once

#include <vector>

#include "identify/conditioning.hpp"
#include "identify/fourier_trajectory.hpp"
#include "identify/motion_limits.hpp"
#include "identify/torque_model.hpp"

namespace flatdyn {

// A motion, sampled as it is written.
struct PlannedMotion {
  FourierTrajectory trajectory;
  std::vector<FourierMotion> samples;
  std::vector<std::vector<double>> torques;  // Y_b π_b of the file, per sample
  std::vector<LimitUse> use;                 // per joint, of the whole limits
  Conditioning conditioning;                 // of all samples
  double cost = 0;                           // excitation_cost() of all samples, columns divided by the lengths

  double time(std::size_t sample) const {
    return trajectory.duration() * static_cast<double>(sample) / static_cast<double>(samples.size() - 1);
  }
};

struct FittedTrajectory {
  FourierTrajectory trajectory;
  // Per joint, of the whole limit: what was used before joints moved less because of torques.
  std::vector<double> torque;
};

// Makes the motion smaller until it uses `margin` of the limits at the most: each joint by itself for position, speed
// and acceleration, which are proportional to its series; then all joints together for the torques of the file's
// parameters. Throws Failure(unsupported) where those are too large at rest. Limits are kept at as many points as the
// highest harmonic needs, and at the samples if there are more of them, with `intervals` between.
FittedTrajectory fitted(const TorqueModel& model, const std::vector<JointLimits>& limits, double margin,
                        const FourierTrajectory& trajectory, int intervals = 1);

// The motion, fitted() to the limits, as it is sampled; lengths: of the columns of Y_b, for conditioning().
PlannedMotion planned(const TorqueModel& model, const std::vector<JointLimits>& limits, double margin,
                      const FourierTrajectory& trajectory, int intervals, const Eigen::VectorXd& lengths);

}  // namespace flatdyn
