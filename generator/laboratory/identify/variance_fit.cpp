// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/variance_fit.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "laboratory/identify/residual_noise.hpp"

namespace flatdyn {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// The x from 0 to `most` that minimises xᵀ H x / 2 - hᵀ x, by coordinates.
VectorXd bounded_minimum(const MatrixXd& H, const VectorXd& h, const VectorXd& most) {
  constexpr int kRounds = 500;
  VectorXd x = VectorXd::Zero(h.size());
  for (int round = 0; round < kRounds; ++round) {
    for (Index k = 0; k < h.size(); ++k) {
      if (H(k, k) <= 0) continue;
      x[k] = std::clamp(x[k] + (h[k] - H.row(k).dot(x)) / H(k, k), 0.0, most[k]);
    }
  }
  return x;
}

// The variances x that minimise xᵀ H x / 2 - hᵀ x, where known ones are measurements, too. These are sure to a share of
// the variance itself: where the residuals are far larger than they say, they hardly count. Of the `optional` ones,
// which come first, those that are zero count as absent in the covariance. `most`: the largest values that they may
// have.
FittedVariances with_known(const MatrixXd& H, const VectorXd& h, const VectorXd& known, const VectorXd& most,
                           Index optional) {
  constexpr int kRounds = 6;
  FittedVariances result;
  for (int round = 0; round < kRounds; ++round) {
    MatrixXd all = H;
    VectorXd right = h;
    for (Index k = 0; k < known.size() && round > 0; ++k) {
      if (known[k] == 0) continue;
      const double weight = kRowsOfKnownNoise / 2 / std::pow(std::max(known[k], result.values[k]), 2);
      all(k, k) += weight;
      right[k] += weight * known[k];
    }
    // Both kinds have very different units: each unknown is scaled by its own column.
    const VectorXd diagonal = all.diagonal();
    const VectorXd units = (diagonal.array() > 0).select(diagonal.cwiseSqrt().cwiseInverse(), 0);
    MatrixXd scaled = units.asDiagonal() * all * units.asDiagonal();
    const VectorXd most_scaled = (units.array() > 0).select(most.cwiseQuotient(units), most);
    result.values = units.cwiseProduct(bounded_minimum(scaled, units.cwiseProduct(right), most_scaled));
    for (Index k = 0; k < optional; ++k) {
      if (result.values[k] > 0) continue;
      scaled.row(k).setZero();
      scaled.col(k).setZero();
    }
    result.covariance =
        units.asDiagonal() * scaled.completeOrthogonalDecomposition().pseudoInverse() * units.asDiagonal();
  }
  return result;
}

}  // namespace

// The same, without noise of accelerations (the last `joints` unknowns) where neither the log gives it nor the
// residuals show it, as with q̈ of its own: its uncertainty alone would widen all intervals.
FittedVariances fitted_variances(const MatrixXd& H, const VectorXd& h, const VectorXd& known, const VectorXd& most,
                                 Index optional, Index joints) {
  const FittedVariances all = with_known(H, h, known, most, optional);
  if (joints == 0 || (known.tail(joints).array() > 0).any()) return all;
  MatrixXd fewer = H;
  fewer.rightCols(joints).setZero();
  fewer.bottomRows(joints).setZero();
  VectorXd right = h;
  right.tail(joints).setZero();
  const FittedVariances without = with_known(fewer, right, known, most, optional);
  const auto misfit = [&](const VectorXd& x) { return x.dot(H * x) - 2 * h.dot(x); };
  // Chance explains about one per joint at most.
  const double explained = misfit(without.values) - misfit(all.values);
  return explained > static_cast<double>(joints) ? all : without;
}

}  // namespace flatdyn
