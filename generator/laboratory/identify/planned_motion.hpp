// SPDX-License-Identifier: GPL-2.0-or-later
// A motion that keeps the limits, and its information on the parameters.
#pragma once

#include <vector>

#include "laboratory/identify/conditioning.hpp"
#include "laboratory/identify/fourier_trajectory.hpp"
#include "laboratory/identify/motion_equations.hpp"
#include "laboratory/identify/motion_limits.hpp"

namespace flatdyn {

// A motion, sampled as it is written.
struct PlannedMotion {
  FourierTrajectory trajectory;
  std::vector<FourierMotion> samples;
  std::vector<std::vector<double>> torques;  // Y_b π_b with the file's π_b, one vector per sample
  std::vector<LimitUse> use;                 // one per coordinate, as shares of the full limits
  Conditioning conditioning;                 // over all samples, and what is known without them
  double cost = 0;                           // excitation_cost() of the same, columns divided by the lengths

  double time(std::size_t sample) const {
    return trajectory.duration() * static_cast<double>(sample) / static_cast<double>(samples.size() - 1);
  }
};

// A trajectory that keeps the limits.
struct FittedTrajectory {
  FourierTrajectory trajectory;
  // The share of the full torque limit per coordinate, before motions were slowed because of torques.
  std::vector<double> torque;
};

// Shrinks the motion until it uses at most `margin` of the limits: first each coordinate for position, speed and
// acceleration, which are proportional to its series; then all together for the torques of the file's parameters, and
// for the twist of a floating base. Throws Failure(unsupported) if those are too large at rest. Limits are checked at
// as many points as the highest harmonic needs, and at the samples, with `intervals` between them, if these are more.
FittedTrajectory fitted(const MotionEquations& equations, const std::vector<JointLimits>& limits, double margin,
                        const FourierTrajectory& trajectory, int intervals = 1);

// The fitted() motion as it is sampled; lengths: those of the columns of Y_b, for conditioning(). known: rows of Y_b
// that count in addition to those of the motion, or none.
PlannedMotion planned(const MotionEquations& equations, const std::vector<JointLimits>& limits, double margin,
                      const FourierTrajectory& trajectory, int intervals, const Eigen::VectorXd& lengths,
                      const Eigen::MatrixXd& known = {});

}  // namespace flatdyn
