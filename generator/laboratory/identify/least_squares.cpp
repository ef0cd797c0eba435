// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/least_squares.hpp"

#include <fmt/format.h>

#include <limits>

#include "base/diagnostics/diagnostics.hpp"
#include "laboratory/identify/damped_solution.hpp"
#include "laboratory/identify/noise_account.hpp"
#include "laboratory/identify/singular_values.hpp"
#include "laboratory/identify/triangular_factor.hpp"

namespace flatdyn {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// The factor R of all joints' rows, (b + 1)². Each row is divided by its σ_i, and by √c where noise is correlated: n
// rows then have no more information than n / c independent ones.
MatrixXd weighted_factor(const Observations& observations, const VectorXd& deviations) {
  const Index size = observations.parameters + 1;
  Index rows = 0;
  for (const JointObservations& joint : observations.joints) rows += joint.R.rows();
  MatrixXd stacked = MatrixXd::Zero(rows, size);
  Index at = 0;
  for (std::size_t i = 0; i < observations.joints.size(); ++i) {
    const JointObservations& joint = observations.joints[i];
    auto block = stacked.middleRows(at, joint.R.rows());
    const double weight = 1 / (deviations(static_cast<Index>(i)) * std::sqrt(joint.correlation));
    block(Eigen::all, joint.columns) = weight * joint.A();
    block.col(size - 1) = weight * joint.b();
    at += joint.R.rows();
  }
  return triangular_factor_of(stacked);
}

// Takes account of the noise that is left in the equations.
void set_noise(Solution& solution, const Observations& observations, const VectorXd& deviations,
               const EstimateOptions& options) {
  VectorXd weights = deviations.cwiseAbs2().cwiseInverse();
  for (Index i = 0; i < weights.size(); ++i) {
    weights(i) /= observations.joints[static_cast<std::size_t>(i)].correlation;
  }
  const VectorXd freedom = shares_of_freedom(observations, solution.spread, deviations);
  take_account_of_noise(solution, observations, weights, freedom, options.acceleration_rows, options.compensates);
}

// σ_i from the residual of joint i and its remaining degrees of freedom, and from the noise above the band. A residual
// below a small share of the largest torque is rounding, not noise; without torques, the same number of N m or N is
// used.
VectorXd residual_deviations(const Observations& observations, const Solution& solution, const VectorXd& deviations) {
  constexpr double kRounding = 1e-13;
  const VectorXd freedom = shares_of_freedom(observations, solution.spread, deviations);
  const auto n = static_cast<Index>(observations.joints.size());
  const VectorXd known = known_squares(observations);
  VectorXd result(n);
  double largest_torque = 0;
  for (const JointObservations& joint : observations.joints) {
    largest_torque = std::max(largest_torque, joint.rms_torque());
  }
  for (Index i = 0; i < n; ++i) {
    const JointObservations& joint = observations.joints[static_cast<std::size_t>(i)];
    const double rows = static_cast<double>(joint.rows), free = rows * freedom(i);
    const double extra = known(i) > 0 ? kRowsOfKnownNoise : 0;
    const double squares = rows * std::pow(joint.rms_residual(solution.values), 2) + extra * known(i);
    result(i) = std::sqrt(squares / std::max(free + extra, 1.0));
    result(i) = std::max({result(i), kRounding * largest_torque, kRounding});
  }
  return result;
}

// The shortest x among those that minimise |A x - b|.
VectorXd shortest_solution(const MatrixXd& A, const VectorXd& b) {
  constexpr double kRankTolerance = 1e-12;
  const Index cols = A.cols();
  MatrixXd joined(A.rows(), cols + 1);
  joined << A, b;
  const MatrixXd R = triangular_factor_of(joined);
  const SingularValues svd = singular_values(R.topLeftCorner(cols, cols));
  const VectorXd inverse = (svd.s.array() > kRankTolerance * svd.s(0)).select(svd.s.cwiseInverse(), 0);
  return svd.V * (inverse.asDiagonal() * (svd.U.transpose() * R.topRightCorner(cols, 1)));
}

// The largest size that parameters can have: that of the prior, or of one that the data tell. A file's masses may be
// far too small.
double plausible_size(const Solution& solution, const VectorXd& prior) {
  constexpr double kClearly = 10;  // standard deviations
  const VectorXd deviations = solution.spread.rowwise().norm();
  double largest = prior.cwiseAbs().maxCoeff();
  for (Index k = 0; k < deviations.size() && largest > 0; ++k) {
    const double value = std::abs(solution.values[k]);
    if (value > kClearly * deviations[k] && deviations[k] > 0) largest = std::max(largest, value);
  }
  return largest;
}

void require_enough(const Observations& observations) {
  long equations = 0;
  for (const JointObservations& joint : observations.joints) equations += joint.rows;
  if (equations > observations.parameters) return;
  throw Failure(
      FailureKind::input,
      fmt::format("{} equations for {} parameters: too few to tell noise by", equations, observations.parameters),
      "log longer runs");
}

}  // namespace

VectorXd shares_of_freedom(const Observations& observations, const MatrixXd& spread, const VectorXd& deviations) {
  VectorXd result(deviations.size());
  for (Index i = 0; i < result.size(); ++i) {
    const JointObservations& joint = observations.joints[static_cast<std::size_t>(i)];
    const double leverage = (joint.A() * spread(joint.columns, Eigen::all) / deviations(i)).squaredNorm();
    const double rows = std::max(static_cast<double>(joint.rows), 1.0);
    result(i) = std::max(rows - leverage, 1.0) / rows;
  }
  return result;
}

Estimate estimate(const Observations& observations, const VectorXd& prior, const EstimateOptions& options) {
  constexpr int kMostIterations = 50;
  constexpr double kStable = 1e-9;
  constexpr double kRounding = 1e-13;  // relative singular values that are rounding, and no information
  Estimate result;
  require_enough(observations);
  const double damping = std::max(options.damping, kRounding);
  VectorXd deviations = VectorXd::Ones(static_cast<Index>(observations.joints.size()));
  Solution solution;
  for (; result.iterations < kMostIterations && !result.converged; ++result.iterations) {
    solution = damped_solution(weighted_factor(observations, deviations), prior, damping);
    const VectorXd updated = residual_deviations(observations, solution, deviations);
    result.converged = ((updated - deviations).cwiseAbs().array() <= kStable * deviations.array()).all();
    deviations = updated;
  }
  set_noise(solution, observations, deviations, options);
  const double plausible = plausible_size(solution, prior);
  if (plausible > 0) damp_hidden_directions(solution, plausible);
  leave_open(solution, plausible);
  result.values = solution.values;
  result.standard_deviations = solution.spread.rowwise().norm();
  result.covariance = solution.spread * solution.spread.transpose();
  for (std::size_t k = 0; k < solution.determined.size(); ++k) {
    if (!solution.determined[k])
      result.standard_deviations(static_cast<Index>(k)) = std::numeric_limits<double>::infinity();
  }
  result.singular_values = solution.singular_values;
  result.damped = std::move(solution.damped);
  result.hidden = std::move(solution.hidden);
  result.noisy = std::move(solution.noisy);
  result.is_compensated = solution.is_compensated;
  result.growth = solution.growth;
  result.compensation = std::move(solution.compensation);
  result.motions = std::move(solution.motions);
  result.torque_deviations = deviations;
  result.root_information = std::move(solution.root_information);
  return result;
}

MatrixXd root_information_of_first(const Estimate& estimate, int count) {
  const MatrixXd& root = estimate.root_information;
  MatrixXd others_first(root.rows(), root.cols());
  others_first << root.rightCols(root.cols() - count), root.leftCols(count);
  return triangular_factor_of(others_first).bottomRightCorner(count, count);
}

namespace {

// Finds the parameters that only these equations have of all that are not known yet.
void add_block(const std::vector<JointObservations>& equations, std::vector<bool>& known, VectorXd& values) {
  std::vector<int> unknown;
  Index rows = 0;
  for (const JointObservations& each : equations) {
    rows += each.R.rows();
    for (const int column : each.columns) {
      if (!known[static_cast<std::size_t>(column)]) unknown.push_back(column);
      known[static_cast<std::size_t>(column)] = true;
    }
  }
  if (unknown.empty()) return;
  MatrixXd A = MatrixXd::Zero(rows, static_cast<Index>(unknown.size()));
  VectorXd rest(rows);
  Index row = 0;
  for (const JointObservations& each : equations) {
    const MatrixXd own = each.A();
    rest.segment(row, own.rows()) = each.b() - own * each.restricted(values);
    for (std::size_t k = 0; k < each.columns.size(); ++k) {
      const auto at = std::find(unknown.begin(), unknown.end(), each.columns[k]);
      if (at != unknown.end()) A.col(at - unknown.begin()).segment(row, own.rows()) = own.col(static_cast<Index>(k));
    }
    row += own.rows();
  }
  values(unknown) += shortest_solution(A, rest);
}

}  // namespace

VectorXd estimate_joint_by_joint(const Observations& observations, const VectorXd& prior,
                                 const std::vector<int>& together) {
  VectorXd values = prior;
  std::vector<bool> known(static_cast<std::size_t>(observations.parameters), false);
  for (std::size_t end = observations.joints.size(); end > 0;) {
    std::size_t first = end - 1;
    while (first > 0 && !together.empty() && together[first - 1] == together[first]) --first;
    const std::vector<JointObservations> rows(observations.joints.begin() + static_cast<std::ptrdiff_t>(first),
                                              observations.joints.begin() + static_cast<std::ptrdiff_t>(end));
    add_block(rows, known, values);
    end = first;
  }
  return values;
}

}  // namespace flatdyn
