// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/noise_account.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "laboratory/identify/noise_scores.hpp"

namespace flatdyn {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// A solution's information split into directions, each with the share of it that is noise of positions.
struct SplitInformation {
  VectorXd shares;      // ascending
  MatrixXd directions;  // orthonormal columns, in the coordinates of the solution
  Index told = 0;       // how many directions, the first ones, the data determine

  MatrixXd told_directions() const { return directions.leftCols(told); }
  MatrixXd open_directions() const { return directions.rightCols(directions.cols() - told); }
  VectorXd gains() const { return (1 - shares.head(told).array()).inverse(); }
};

SplitInformation split(const Solution& solution, const MatrixXd& false_information) {
  const Index size = solution.spread.rows();
  const MatrixXd information = false_information.topLeftCorner(size, size);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(
      MatrixXd(solution.spread.transpose() * information * solution.spread));
  SplitInformation result{eigen.eigenvalues(), eigen.eigenvectors()};
  result.told = (result.shares.array() <= NoisyDirection::kMost).count();
  return result;
}

MatrixXd weighted_sum(const std::vector<MatrixXd>& of_joints, const VectorXd& variances) {
  MatrixXd sum = variances[0] * of_joints[0];
  for (std::size_t j = 1; j < of_joints.size(); ++j) sum += variances[static_cast<Index>(j)] * of_joints[j];
  return sum;
}

// E[ΔYᵀ W ΔY] times the parameters, the known part of the torques among them.
VectorXd false_moment(const MatrixXd& false_information, const VectorXd& values) {
  return false_information.topRows(values.size()) * with_known_part(values, false_information.cols());
}

// The coordinates along the determined directions without what noise of positions makes of them. `fitted`: the values
// of least squares.
VectorXd told_coordinates(const Solution& solution, const SplitInformation& split, const MatrixXd& false_information,
                          const VectorXd& fitted) {
  const VectorXd bias = solution.spread.transpose() * false_moment(false_information, fitted);
  return split.told_directions().transpose() * solution.coordinates +
         split.gains().cwiseProduct(split.told_directions().transpose() * bias);
}

// The covariance of the determined coordinates: that of the scores, and what the errors of the noise's variances make.
MatrixXd told_covariance(const Solution& solution, const SplitInformation& split, const MatrixXd& scores,
                         const std::vector<MatrixXd>& of_joints, const ResidualNoise& noise) {
  const MatrixXd map = solution.spread * split.told_directions() * split.gains().asDiagonal();
  MatrixXd covariance = map.transpose() * scores * map;
  if (of_joints.empty()) return covariance;
  MatrixXd by_variance(split.told, noise.acceleration.size());
  for (std::size_t j = 0; j < of_joints.size(); ++j) {
    by_variance.col(static_cast<Index>(j)) = map.transpose() * false_moment(of_joints[j], solution.values);
  }
  covariance += by_variance * noise.acceleration_covariance * by_variance.transpose();
  return covariance;
}

// Leaves only the determined directions in the solution's coordinates, with a covariance of 1 again.
void set_told(Solution& solution, const SplitInformation& split, const VectorXd& coordinates,
              const MatrixXd& covariance) {
  constexpr double kLeast = 1e-4;  // share of the variance of white noise
  solution.open = solution.spread * split.open_directions();
  if (split.told == 0) {
    solution.spread.resize(Eigen::NoChange, 0);
    solution.coordinates.resize(0);
    solution.root_information.resize(0, Eigen::NoChange);
    return;
  }
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(covariance);
  const VectorXd root = eigen.eigenvalues().cwiseMax(kLeast).cwiseSqrt();
  const MatrixXd turned = root.cwiseInverse().asDiagonal() * eigen.eigenvectors().transpose();
  solution.spread = solution.spread * split.told_directions() * eigen.eigenvectors() * root.asDiagonal();
  solution.coordinates = turned * coordinates;
  solution.root_information = turned * split.told_directions().transpose() * solution.root_information;
}

// Whether the values leave far more than least squares do, whose values are `fitted`. Where noise of positions is a
// share of what the data say, the residuals grow by about half of that share when it is taken off, and it is less than
// NoisyDirection::kMost: much more shows that what looks like noise is motion.
bool is_of_motion(Solution& solution, const Observations& observations, const VectorXd& fitted) {
  constexpr double kMost = 1.1;
  for (const JointObservations& joint : observations.joints) {
    const double least = joint.rms_residual(fitted);
    if (joint.rows == 0 || !(least > 0)) continue;
    solution.growth = std::max(solution.growth, joint.rms_residual(solution.values) / least);
  }
  return solution.growth > kMost;
}

}  // namespace

void take_account_of_noise(Solution& solution, const Observations& observations, const VectorXd& weights,
                           const VectorXd& freedom, const AccelerationRows& rows, bool compensates) {
  constexpr int kRounds = 3;  // the noise depends on the inertia, and so on the values
  if (observations.instants.empty() || solution.coordinates.size() == 0) return;
  const NoiseStructure structure(observations);
  const std::vector<MatrixXd> of_joints = false_information(structure, weights, rows);
  const VectorXd fitted = solution.values;
  const VectorXd origin = fitted - solution.spread * solution.coordinates;
  const Index all = solution.coordinates.size();
  const SplitInformation whole{VectorXd::Zero(all), MatrixXd::Identity(all, all), all};
  SplitInformation parts = whole;
  VectorXd coordinates = solution.coordinates;
  const NoiseSearch search(structure, {solution.spread, weights, freedom}, rows);
  ResidualNoise noise = search.noise_of(fitted);
  for (int round = 0; round < kRounds && !of_joints.empty(); ++round) {
    const MatrixXd of_noise = weighted_sum(of_joints, noise.acceleration);
    parts = split(solution, of_noise);
    coordinates = told_coordinates(solution, parts, of_noise, fitted);
    solution.values = origin + solution.spread * (parts.told_directions() * coordinates);
    noise = search.noise_of(solution.values);
  }
  for (Index k = 0; k < all; ++k) {
    solution.noisy.push_back({parts.shares[k], solution.spread * parts.directions.col(k)});
  }
  if (!of_joints.empty()) solution.compensation = fitted - solution.values;
  solution.motions = structure.motions();
  const bool is_kept = compensates && !of_joints.empty() && !is_of_motion(solution, observations, fitted);
  solution.is_compensated = is_kept;
  if (compensates && !is_kept) solution.noisy.clear();
  if (!is_kept) {
    solution.values = fitted;
    coordinates = solution.coordinates;
    parts = whole;
    noise = search.noise_of(fitted);
  }
  const MatrixXd scores = score_covariance(structure, solution.values, weights, noise, rows);
  const std::vector<MatrixXd> compensated = is_kept ? of_joints : std::vector<MatrixXd>();
  set_told(solution, parts, coordinates, told_covariance(solution, parts, scores, compensated, noise));
}

}  // namespace flatdyn
