// SPDX-License-Identifier: GPL-2.0-or-later
// Whether the residuals of a fit are the log's noise. White noise of torques and positions shows above the filter's
// band, where no motion is; what the filter leaves of it is what residuals should be. Residuals that are much larger,
// and each like the one before it, come from something that the model lacks, or from a log that is not what it says.
#pragma once

#include <optional>
#include <vector>

#include "laboratory/identify/measurement.hpp"
#include "laboratory/identify/residual_noise.hpp"

namespace flatdyn {

struct JointFit {
  double expected = 0;      // root mean square of the residuals that the noise above the band makes, N m or N
  double ratio = 0;         // that of the residuals, divided by `expected`
  double correlation = 0;   // of residuals one row apart: -1 … 1
  double of_positions = 0;  // share of the squares of `expected` that noise of the positions makes: 0 … 1
  std::optional<double> limit = std::nullopt;  // where the torques look cut off, N m or N

  // Whether the residuals are no more than noise. Noise that the band has more of than what is above it is sound, too,
  // as long as it is not many times as much, or slow.
  bool is_sound() const { return ratio < kSound || (ratio < kMostSound && correlation < kCorrelated); }
  // Whether it is worth while to look for a reason. Noise of positions makes residuals change their sign from row to
  // row; what a model lacks does not.
  bool is_suspicious() const { return ratio > kClear || (ratio > kSuspicious && correlation > kAlternating); }
  // Whether the noise is mostly that of steps of the encoder, and not white: intervals then are not sure.
  bool is_of_coarse_steps() const { return of_positions > kMostly && ratio < kNotWhite; }
  static constexpr double kSound = 1.5, kMostSound = 4, kCorrelated = 0.5;
  static constexpr double kClear = 2, kSuspicious = 1.15, kAlternating = -0.25;
  static constexpr double kMostly = 0.8, kNotWhite = 0.75;
};

// By equation; zeros for one without rows. `logs` are those of the observations' instants; values: of all parameters.
std::vector<JointFit> fit_quality(const Observations& observations, const std::vector<MeasuredLog>& logs,
                                  const Eigen::VectorXd& values, const AccelerationRows& rows);

}  // namespace flatdyn
