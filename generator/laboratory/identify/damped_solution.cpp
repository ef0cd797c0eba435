// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/damped_solution.hpp"

#include <cmath>

#include "laboratory/identify/singular_values.hpp"

namespace flatdyn {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// Marks parameters as not determined of which directions leave much of the plausible size open.
void mark_open(Solution& solution, const MatrixXd& directions, double plausible) {
  constexpr double kMuch = 0.1;  // share of the plausible size
  const VectorXd left = directions.rowwise().norm();
  for (Index k = 0; k < left.size(); ++k) {
    if (left(k) > kMuch * plausible) solution.determined[static_cast<std::size_t>(k)] = false;
  }
}

// The columns without those that are nothing but rounding errors, as of parameters that only a held joint would show:
// they would count as information once they are scaled to unit length.
MatrixXd without_rounding(MatrixXd columns) {
  constexpr double kRoundingColumn = 1e-11;  // share of the longest
  const VectorXd lengths = columns.colwise().norm();
  for (Index k = 0; k < lengths.size(); ++k) {
    if (lengths(k) < kRoundingColumn * lengths.maxCoeff()) columns.col(k).setZero();
  }
  return columns;
}

}  // namespace

Solution damped_solution(const MatrixXd& factor, const VectorXd& prior, double damping) {
  constexpr double kRounding = 1e-6;
  const Index b = prior.size();
  const MatrixXd A = without_rounding(factor.topLeftCorner(b, b));
  VectorXd scale = A.colwise().norm();
  scale = (scale.array() > 0).select(scale, 1);
  const SingularValues svd = singular_values(A * scale.cwiseInverse().asDiagonal());
  const double smallest = damping * svd.s(0);
  VectorXd inverse(b);
  VectorXd parts = VectorXd::Zero(b);  // share of each parameter that lies in damped directions
  Solution solution;
  for (Index k = 0; k < b; ++k) {
    const double s = svd.s(k);
    inverse(k) = s > smallest ? 1 / s : s / (s * s + smallest * smallest);
    if (s > smallest) continue;
    if (smallest == 0) inverse(k) = 0;
    solution.damped.push_back({s / svd.s(0), svd.V.col(k)});
    parts += svd.V.col(k).cwiseAbs();
  }
  const Index known = b - static_cast<Index>(solution.damped.size());
  for (const double part : parts) solution.determined.push_back(part < kRounding);
  solution.singular_values = svd.s;
  solution.root_information = svd.s.head(known).asDiagonal() * svd.V.leftCols(known).transpose() * scale.asDiagonal();
  const MatrixXd spread = scale.cwiseInverse().asDiagonal() * svd.V * inverse.asDiagonal();
  const VectorXd misfit = factor.topRightCorner(b, 1) - A * prior;
  const VectorXd coordinates = svd.U.transpose() * misfit;
  solution.values = prior + spread * coordinates;
  solution.spread = spread.leftCols(known);
  solution.coordinates = coordinates.head(known);
  return solution;
}

// Works along the principal directions of the covariance. A hidden direction keeps the variance that the prior leaves.
void damp_hidden_directions(Solution& solution, double plausible) {
  constexpr double kClearly = 5;  // standard deviations
  if (solution.coordinates.size() == 0) return;
  const SingularValues svd = singular_values_of_tall(solution.spread);
  const VectorXd coordinates = svd.V.transpose() * solution.coordinates;
  MatrixXd directions = solution.spread * svd.V;  // column k is as long as its standard deviation
  std::vector<Index> known, hidden;
  for (Index k = 0; k < coordinates.size(); ++k) {
    auto direction = directions.col(k);
    const double deviation = direction.norm();
    const bool is_hidden = deviation > plausible && std::abs(coordinates(k)) < kClearly;
    (is_hidden ? hidden : known).push_back(k);
    if (!is_hidden) continue;
    solution.hidden.push_back({deviation, direction.normalized()});
    const double share = 1 / (1 + std::pow(deviation / plausible, 2));
    solution.values -= (1 - share) * coordinates(k) * direction;
    direction *= std::sqrt(share);
  }
  if (hidden.empty()) return;
  solution.root_information = (svd.V.transpose() * solution.root_information)(known, Eigen::all).eval();
  solution.spread = directions;
  mark_open(solution, directions(Eigen::all, hidden), plausible);
}

void leave_open(Solution& solution, double plausible) {
  if (solution.open.cols() == 0) return;
  const MatrixXd directions = solution.open.colwise().normalized();
  MatrixXd spread(solution.spread.rows(), solution.spread.cols() + directions.cols());
  spread << solution.spread, plausible * directions;
  solution.spread = std::move(spread);
  mark_open(solution, directions, 1);
}

}  // namespace flatdyn
