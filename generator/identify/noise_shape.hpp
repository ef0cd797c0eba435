// SPDX-License-Identifier: GPL-2.0-or-later
// How the filter shapes white noise of a log: the correlation between rows of the equations that are used.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "identify/motion_stream.hpp"

namespace flatdyn {

// Autocorrelations at lags 0, 1, … of rows, for white noise of variance 1 in every sample.
struct NoiseShape {
  int run = 1;               // instants that are looked at together: more than one where noise is correlated
  Eigen::VectorXd measured;  // that of noise in the measured torques
  // That of noise in the logged q, q̇ or q̈, as it appears in q̈; zero in a log of poses, whose q̈ is zero and no reading.
  Eigen::VectorXd acceleration;
  // Those of noise in the measured torques that is slower than white noise: its power falls above shares kColours of
  // the filter's band. All zero without a filter.
  std::vector<Eigen::VectorXd> coloured{};
  // Standard deviations of the noise above the band, in one sample, by equation and by joint; empty if not known, as
  // without a filter: rows may then lie far apart, and what changes from one to the next is motion.
  std::vector<double> measured_deviations{}, acceleration_deviations{};

  // The correlation of the torque's noise, at least 1: this many rows tell as much about what is slow as one row with
  // white noise of the same size.
  double correlation() const;

  static constexpr std::array<double, 3> kColours{0.5, 0.15, 0.05};
};

// The derivatives of q that a log has. `held`: both, and all rates are zero, as in logs of poses.
enum class LogDerivatives : std::uint8_t { none, rates, both, held };
LogDerivatives derivatives_of(const StreamPlan& plan);

NoiseShape noise_shape(const SampleFilter& filter, LogDerivatives derivatives);

}  // namespace flatdyn
