// SPDX-License-Identifier: GPL-2.0-or-later
#include "identify/instrumental_variables.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <limits>

namespace flatdyn {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

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

// In coordinates c along the directions that are told, π = π_ls + spread c.
Estimate InstrumentSums::estimate(const Observations& observations, const Estimate& least_squares,
                                  const AccelerationRows& acceleration_rows) const {
  const Index b = least_squares.values.size();
  const MatrixXd spread = least_squares.root_information.completeOrthogonalDecomposition().pseudoInverse();
  MatrixXd A = MatrixXd::Zero(b, b);
  VectorXd h = VectorXd::Zero(b), weights = VectorXd::Zero(static_cast<Index>(products_.size()));
  for (std::size_t i = 0; i < products_.size(); ++i) {
    if (observations.joints[i].rows == 0) continue;
    const std::vector<int>& columns = equations_.columns()[i];
    const double weight = std::pow(least_squares.torque_deviations(static_cast<Index>(i)), -2);
    weights(static_cast<Index>(i)) = weight;
    A(columns, columns) += weight * products_[i];
    h(columns) += weight * right_[i];
  }
  const MatrixXd inverse = MatrixXd(spread.transpose() * A * spread).inverse();
  Estimate result = least_squares;
  result.values += spread * (inverse * (spread.transpose() * (h - A * least_squares.values)));
  Observations of_instruments = observations;
  for (EquationInstant& instant : of_instruments.instants) instant.entries = instant.instruments;
  const ResidualNoise noise =
      residual_noise(observations, result.values, VectorXd::Ones(weights.size()), acceleration_rows);
  const MatrixXd scores = score_covariance(of_instruments, result.values, weights, noise, acceleration_rows);
  const MatrixXd covariance = inverse * (spread.transpose() * scores * spread) * inverse.transpose();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen((covariance + covariance.transpose()) / 2);
  const VectorXd root = eigen.eigenvalues().cwiseMax(std::numeric_limits<double>::min()).cwiseSqrt();
  const MatrixXd own = spread * eigen.eigenvectors() * root.asDiagonal();
  result.covariance = own * own.transpose();
  result.root_information =
      root.cwiseInverse().asDiagonal() * eigen.eigenvectors().transpose() * least_squares.root_information;
  for (Index k = 0; k < b; ++k) {
    if (std::isfinite(result.standard_deviations(k)))
      result.standard_deviations(k) = std::sqrt(result.covariance(k, k));
  }
  return result;
}

}  // namespace flatdyn
