// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/instrumental_variables.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "base/diagnostics/diagnostics.hpp"
#include "laboratory/identify/noise_scores.hpp"

namespace flatdyn {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

void require_told(const VectorXd& values) {
  if (values.allFinite()) return;
  throw Failure(FailureKind::input, "the instruments of --estimator iv tell too little of the parameters",
                "log a slower or a longer motion, or leave --estimator iv out");
}

// Sets the covariance of the coordinates along `spread`, and what follows from it.
void set_covariance(Estimate& result, const MatrixXd& spread, const MatrixXd& covariance) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(MatrixXd((covariance + covariance.transpose()) / 2));
  const VectorXd root = eigen.eigenvalues().cwiseMax(std::numeric_limits<double>::min()).cwiseSqrt();
  const MatrixXd own = spread * eigen.eigenvectors() * root.asDiagonal();
  result.covariance = own * own.transpose();
  result.root_information =
      root.cwiseInverse().asDiagonal() * eigen.eigenvectors().transpose() * result.root_information;
  for (Index k = 0; k < result.values.size(); ++k) {
    if (std::isfinite(result.standard_deviations(k)))
      result.standard_deviations(k) = std::sqrt(result.covariance(k, k));
  }
}

}  // namespace

InstrumentSums::InstrumentSums(const EquationModel& equations) : equations_(equations) {
  for (const std::vector<int>& columns : equations.columns()) {
    const auto size = static_cast<Index>(columns.size());
    products_.push_back(MatrixXd::Zero(size, size));
    right_.push_back(VectorXd::Zero(size));
  }
}

void InstrumentSums::add(const FilteredEquations& each) {
  const double *entries = each.entries, *instruments = each.instruments;
  for (std::size_t i = 0; i < products_.size(); ++i) {
    const Index size = right_[i].size();
    const Eigen::Map<const VectorXd> y(entries, size), z(instruments, size);
    if (each.used[i] != 0) {
      products_[i].noalias() += z * y.transpose();
      right_[i] += each.right[i] * z;
    }
    entries += size;
    instruments += size;
  }
}

// In coordinates c along the directions that are determined, π = π_ls + spread c. Least squares takes the noise of q
// for noise of the torques here: it gives the directions and the weights, and its bias does not matter.
Estimate InstrumentSums::estimate(const Observations& observations, const VectorXd& prior,
                                  const EstimateOptions& options) const {
  EstimateOptions plain = options;
  plain.acceleration_rows = nullptr;
  Estimate result = flatdyn::estimate(observations, prior, plain);
  const Index b = result.values.size();
  const MatrixXd spread = result.root_information.completeOrthogonalDecomposition().pseudoInverse();
  MatrixXd A = MatrixXd::Zero(b, b);
  VectorXd h = VectorXd::Zero(b), weights = VectorXd::Zero(static_cast<Index>(products_.size()));
  for (std::size_t i = 0; i < products_.size(); ++i) {
    if (observations.joints[i].rows == 0) continue;
    const std::vector<int>& columns = equations_.columns()[i];
    const double weight = std::pow(result.torque_deviations(static_cast<Index>(i)), -2);
    weights(static_cast<Index>(i)) = weight;
    A(columns, columns) += weight * products_[i];
    h(columns) += weight * right_[i];
  }
  const MatrixXd inverse = MatrixXd(spread.transpose() * A * spread).inverse();
  result.values += spread * (inverse * (spread.transpose() * (h - A * result.values)));
  require_told(result.values);
  Observations of_instruments = observations;
  for (EquationInstant& instant : of_instruments.instants) instant.entries = instant.instruments;
  const VectorXd freedom = shares_of_freedom(observations, spread, result.torque_deviations);
  const NoiseStructure structure(observations);
  const ResidualNoise noise =
      NoiseSearch(structure, {spread, weights, freedom}, options.acceleration_rows).noise_of(result.values);
  const MatrixXd scores =
      score_covariance(NoiseStructure(of_instruments), result.values, weights, noise, options.acceleration_rows);
  set_covariance(result, spread, inverse * (spread.transpose() * scores * spread) * inverse.transpose());
  return result;
}

}  // namespace flatdyn
