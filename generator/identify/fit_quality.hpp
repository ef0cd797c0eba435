// SPDX-License-Identifier: GPL-2.0-or-later
// Whether the residuals of a fit are the log's noise. White noise of torques and positions shows above the filter's
// band, where no motion is; what the filter leaves of it is what residuals should be. Residuals that are much larger,
// and each like the one before it, come from something that the model lacks, or from a log that is not what it says.
#pragma once

#include <optional>
#include <vector>

#include "identify/measurement.hpp"
#include "identify/residual_noise.hpp"

namespace flatdyn {

struct JointFit {
  double expected = 0;     // root mean square of the residuals that the noise above the band makes, N m or N
  double ratio = 0;        // that of the residuals, divided by `expected`
  double correlation = 0;  // of residuals one row apart: -1 … 1
  std::optional<double> limit = std::nullopt;  // where the torques look cut off, N m or N

  // Whether the residuals are no more than noise: the noise of encoders is not always white.
  bool is_sound() const { return ratio < kSound || correlation < kCorrelated; }
  // Whether it is worth while to look for a reason.
  bool is_suspicious() const { return ratio > kSuspicious; }
  static constexpr double kSound = 2, kCorrelated = 0.5, kSuspicious = 1.15;
};

// By equation; zeros for one without rows. `logs` are those of the observations' instants; values: of all parameters.
std::vector<JointFit> fit_quality(const Observations& observations, const std::vector<MeasuredLog>& logs,
                                  const Eigen::VectorXd& values, const AccelerationRows& rows);

}  // namespace flatdyn
