// SPDX-License-Identifier: GPL-2.0-or-later
// How the filter shapes white noise of a log: the correlation between rows of the equations that are used.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "laboratory/identify/motion_stream.hpp"

namespace flatdyn {

// Autocorrelations at lags 0, 1, … of rows, for white noise of variance 1 in every sample.
struct NoiseShape {
  int run = 1;               // instants that are looked at together: more than one where noise is correlated
  Eigen::VectorXd measured;  // that of noise in the measured torques
  // Those of noise in the readings that q̈ is made of, q, q̇ or q̈, as it appears in q̈, by entry of q̈; zero in a log of
  // poses, whose q̈ is zero and no reading.
  std::vector<Eigen::VectorXd> acceleration;
  // Those of noise in the measured torques that is slower than white noise: its power falls above shares kColours of
  // the filter's band. All zero without a filter.
  std::vector<Eigen::VectorXd> coloured{};
  // Standard deviations of the noise above the band, in one sample, by equation and by entry of q̈; empty, or zero, if
  // not known, as without a filter: rows may then lie far apart, and what changes from one to the next is motion.
  std::vector<double> measured_deviations{}, acceleration_deviations{};
  // The variances that the noise by entry of q̈ has at most; infinite if nothing bounds it.
  std::vector<double> most_of_accelerations{};

  // The correlation of the torque's noise, at least 1: this many rows have as much information on what is slow as one
  // row with white noise of the same size.
  double correlation() const;

  static constexpr std::array<double, 4> kColours{0.5, 0.15, 0.05, 0.015};
};

// How often the readings are differentiated that the entries of q̈ are made of: 2 of positions, 1 of rates, 0 of
// accelerations, and kHeld where all rates are zero, as in logs of poses.
constexpr int kHeld = -1;
std::vector<int> differentiations(const StreamPlan& plan);

NoiseShape noise_shape(const SampleFilter& filter, const std::vector<int>& differentiations);

}  // namespace flatdyn
