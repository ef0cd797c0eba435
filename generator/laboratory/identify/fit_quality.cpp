// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/fit_quality.hpp"

#include <algorithm>
#include <cmath>

namespace flatdyn {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// By joint: the mean squares of what noise of the torques and noise of the positions leave in the rows that are used.
struct ExpectedSquares {
  VectorXd of_torques, of_positions;
};

ExpectedSquares expected_squares(const Observations& observations, const std::vector<MeasuredLog>& logs,
                                 const MatrixXd& left, const VectorXd& values, const AccelerationRows& rows) {
  const std::vector<EquationInstant>& instants = observations.instants;
  VectorXd counts = VectorXd::Zero(left.cols());
  ExpectedSquares sums{counts, counts};
  const std::vector<MatrixXd> B = inertias(observations, values, rows);
  for (std::size_t t = 0; t < instants.size(); ++t) {
    const MeasuredLog& log = logs[static_cast<std::size_t>(instants[t].log)];
    if (is_held(log)) continue;
    const NoiseShape& shape = observations.shapes[static_cast<std::size_t>(instants[t].log)];
    for (Index i = 0; i < left.cols(); ++i) {
      if (std::isnan(left(static_cast<Index>(t), i))) continue;
      const Index place = i - instants[t].first;
      const auto at = static_cast<std::size_t>(place);
      sums.of_torques[i] += shape.measured[0] * std::pow(log.tau_noise[at].deviation, 2);
      for (Index j = 0; j < B[t].cols(); ++j) {
        const auto joint = static_cast<std::size_t>(j);
        const double torque = B[t](place, j) * log.q_noise[joint].deviation;
        sums.of_positions[i] += shape.acceleration[joint][0] * torque * torque;
      }
      counts[i] += 1;
    }
  }
  counts = counts.cwiseMax(1);
  return {sums.of_torques.cwiseQuotient(counts), sums.of_positions.cwiseQuotient(counts)};
}

// The correlation of a joint's residuals that are one row apart.
double correlation_of_neighbours(const std::vector<EquationInstant>& instants, const VectorXd& residual) {
  double products = 0, squares = 0;
  for (std::size_t t = 1; t < instants.size(); ++t) {
    const double before = residual[static_cast<Index>(t) - 1], now = residual[static_cast<Index>(t)];
    const bool are_neighbours =
        instants[t].log == instants[t - 1].log && instants[t].index == instants[t - 1].index + 1;
    if (!are_neighbours || std::isnan(before) || std::isnan(now)) continue;
    products += before * now;
    squares += (before * before + now * now) / 2;
  }
  return squares > 0 ? products / squares : 0;
}

// Where the torques of a joint look cut off. A signal passes through the upper and the lower part of its range: there
// are about as many readings in one interval as in the next one. One that is cut off stays at the limit. Instants at
// which the joint or the robot stands still do not count.
std::optional<double> limit_of(const std::vector<EquationInstant>& instants, Index equation, double noise) {
  constexpr double kShare = 0.05;  // of the time, at least
  constexpr double kHalf = 5;      // half the width of an interval, in units of the noise
  constexpr int kTimesMore = 8, kLeast = 10;
  std::vector<double> torques;
  for (const EquationInstant& instant : instants) {
    const bool moves = std::any_of(instant.qd.begin(), instant.qd.end(), [](double qd) { return std::abs(qd) > 1e-6; });
    const Index place = equation - instant.first;
    if (!moves || place < 0 || place >= static_cast<Index>(instant.right.size())) continue;
    if (instant.used[static_cast<std::size_t>(place)] == 0) continue;
    torques.push_back(instant.right[static_cast<std::size_t>(place)]);
  }
  std::sort(torques.begin(), torques.end());
  const auto between = [&](double low, double high) {
    return std::lower_bound(torques.begin(), torques.end(), high) -
           std::lower_bound(torques.begin(), torques.end(), low);
  };
  const auto count = static_cast<double>(torques.size());
  for (const double share : {kShare / 2, 1 - kShare / 2}) {
    if (torques.empty()) break;
    const double limit = torques[static_cast<std::size_t>(share * count)], half = kHalf * noise;
    const double inner = share < 0.5 ? limit + 2 * half : limit - 2 * half;
    const auto near = between(limit - half, limit + half), beside = between(inner - half, inner + half);
    if (near > kLeast + kTimesMore * beside && static_cast<double>(near) > kShare * count) return limit;
  }
  return std::nullopt;
}

}  // namespace

// Rows of a log with all derivatives are not filtered: their noise is no larger in the fit than above any band, and the
// filter's own error is a share of the torque. Between poses all torques change: only the residuals show the noise.
std::vector<JointFit> fit_quality(const Observations& observations, const std::vector<MeasuredLog>& logs,
                                  const VectorXd& values, const AccelerationRows& rows) {
  constexpr double kFiltersError = 1e-4;
  const MatrixXd left = residuals(observations, values);
  const ExpectedSquares squares = expected_squares(observations, logs, left, values, rows);
  const bool are_poses = std::all_of(logs.begin(), logs.end(), is_held) && !logs.empty();
  std::vector<JointFit> fits;
  for (Index i = 0; i < left.cols(); ++i) {
    const JointObservations& joint = observations.joints[static_cast<std::size_t>(i)];
    JointFit fit;
    if (joint.rows > 0) {
      fit.expected = std::max(
          {std::sqrt(squares.of_torques[i] + squares.of_positions[i]), kFiltersError * joint.rms_torque(), 1e-12});
      if (are_poses) fit.expected = std::max(joint.rms_residual(values), 1e-12);
      fit.ratio = joint.rms_residual(values) / fit.expected;
      fit.of_positions = squares.of_positions[i] / std::pow(fit.expected, 2);
      fit.correlation = correlation_of_neighbours(observations.instants, left.col(i));
      if (!fit.is_sound() && joint.rms_torque() > 0) fit.limit = limit_of(observations.instants, i, fit.expected);
    }
    fits.push_back(fit);
  }
  return fits;
}

}  // namespace flatdyn
