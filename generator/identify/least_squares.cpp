// SPDX-License-Identifier: GPL-2.0-or-later
#include "identify/least_squares.hpp"

#include <fmt/format.h>

#include <limits>

#include "diagnostics/diagnostics.hpp"
#include "identify/singular_values.hpp"
#include "identify/triangular_factor.hpp"

namespace flatdyn {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// R of all joints' rows, each divided by its σ_i: (b + 1)².
MatrixXd weighted_factor(const Observations& observations, const VectorXd& deviations) {
  const Index size = observations.parameters + 1;
  Index rows = 0;
  for (const JointObservations& joint : observations.joints) rows += joint.R.rows();
  MatrixXd stacked = MatrixXd::Zero(rows, size);
  Index at = 0;
  for (std::size_t i = 0; i < observations.joints.size(); ++i) {
    const JointObservations& joint = observations.joints[i];
    auto block = stacked.middleRows(at, joint.R.rows());
    block(Eigen::all, joint.columns) = joint.A() / deviations(static_cast<Index>(i));
    block.col(size - 1) = joint.b() / deviations(static_cast<Index>(i));
    at += joint.R.rows();
  }
  return triangular_factor_of(stacked);
}

// The solution for given weights.
struct Solution {
  VectorXd values;
  MatrixXd spread;            // spread spreadᵀ is the covariance where the weights are right, less what is damped
  MatrixXd root_information;  // as in Estimate
  std::vector<bool> told;     // parameters that no damped direction has a part in
  VectorXd singular_values;
  std::vector<DampedDirection> damped;
};

Solution solve(const MatrixXd& factor, const VectorXd& prior, double damping) {
  const Index b = prior.size();
  const MatrixXd A = factor.topLeftCorner(b, b);
  VectorXd scale = A.colwise().norm();
  scale = (scale.array() > 0).select(scale, 1);
  const MatrixXd scaled = A * scale.cwiseInverse().asDiagonal();
  const SingularValues svd = singular_values(scaled);
  Solution solution;
  solution.singular_values = svd.s;
  const double smallest = damping * solution.singular_values(0);
  VectorXd inverse(b);
  VectorXd hidden = VectorXd::Zero(b);  // how much of each parameter lies in damped directions
  for (Index k = 0; k < b; ++k) {
    const double s = solution.singular_values(k);
    inverse(k) = s > smallest ? 1 / s : s / (s * s + smallest * smallest);
    if (s > smallest) continue;
    if (smallest == 0) inverse(k) = 0;
    solution.damped.push_back({s / solution.singular_values(0), svd.V.col(k)});
    hidden += svd.V.col(k).cwiseAbs();
  }
  const Index known = b - static_cast<Index>(solution.damped.size());
  solution.root_information = svd.s.head(known).asDiagonal() * svd.V.leftCols(known).transpose() * scale.asDiagonal();
  constexpr double kRounding = 1e-6;
  for (const double part : hidden) solution.told.push_back(part < kRounding);
  solution.spread = scale.cwiseInverse().asDiagonal() * svd.V * inverse.asDiagonal();
  const VectorXd misfit = factor.topRightCorner(b, 1) - A * prior;
  solution.values = prior + solution.spread * (svd.U.transpose() * misfit);
  return solution;
}

// σ_i from the residual of joint i and the degrees of freedom that are left to it; of correlated noise a fit takes
// more samples. What rounding leaves is no noise:
// less than this part of the largest torque, or than as many N m where there is none.
VectorXd residual_deviations(const Observations& observations, const Solution& solution, const VectorXd& deviations) {
  constexpr double kRounding = 1e-13;
  const auto n = static_cast<Index>(observations.joints.size());
  VectorXd result(n);
  double largest_torque = 0;
  for (const JointObservations& joint : observations.joints) {
    largest_torque = std::max(largest_torque, joint.rms_torque());
  }
  for (Index i = 0; i < n; ++i) {
    const JointObservations& joint = observations.joints[static_cast<std::size_t>(i)];
    const double leverage = (joint.A() * solution.spread(joint.columns, Eigen::all) / deviations(i)).squaredNorm();
    const auto rows = static_cast<double>(joint.rows);
    const double freedom = std::max(rows - observations.correlation * leverage, 1.0);
    result(i) = joint.rms_residual(solution.values) * std::sqrt(rows / freedom);
    result(i) = std::max({result(i), kRounding * largest_torque, kRounding});
  }
  return result;
}

// The shortest x of those with the least norm of A x - b.
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

void require_enough(const Observations& observations) {
  long equations = 0;
  for (const JointObservations& joint : observations.joints) equations += joint.rows;
  if (equations > observations.parameters) return;
  throw Failure(
      ExitCode::input,
      fmt::format("{} equations for {} parameters: too few to tell noise by", equations, observations.parameters),
      "log longer runs");
}

}  // namespace

Estimate estimate(const Observations& observations, const VectorXd& prior, const EstimateOptions& options) {
  constexpr int kMostIterations = 50;
  constexpr double kStable = 1e-9;
  Estimate result;
  require_enough(observations);
  VectorXd deviations = VectorXd::Ones(static_cast<Index>(observations.joints.size()));
  Solution solution;
  for (; result.iterations < kMostIterations && !result.converged; ++result.iterations) {
    solution = solve(weighted_factor(observations, deviations), prior, options.damping);
    const VectorXd updated = residual_deviations(observations, solution, deviations);
    result.converged = ((updated - deviations).cwiseAbs().array() <= kStable * deviations.array()).all();
    deviations = updated;
  }
  result.values = solution.values;
  const double wider = std::sqrt(observations.correlation);
  result.standard_deviations = wider * solution.spread.rowwise().norm();
  for (std::size_t k = 0; k < solution.told.size(); ++k) {
    if (!solution.told[k]) result.standard_deviations(static_cast<Index>(k)) = std::numeric_limits<double>::infinity();
  }
  result.singular_values = solution.singular_values;
  result.damped = std::move(solution.damped);
  result.torque_deviations = deviations;
  result.root_information = solution.root_information / wider;
  return result;
}

MatrixXd root_information_of_first(const Estimate& estimate, int count) {
  const MatrixXd& root = estimate.root_information;
  MatrixXd others_first(root.rows(), root.cols());
  others_first << root.rightCols(root.cols() - count), root.leftCols(count);
  return triangular_factor_of(others_first).bottomRightCorner(count, count);
}

VectorXd estimate_joint_by_joint(const Observations& observations) {
  VectorXd values = VectorXd::Zero(observations.parameters);
  std::vector<bool> known(static_cast<std::size_t>(observations.parameters), false);
  for (auto joint = observations.joints.rbegin(); joint != observations.joints.rend(); ++joint) {
    std::vector<int> places, unknown;
    for (std::size_t k = 0; k < joint->columns.size(); ++k) {
      const int column = joint->columns[k];
      if (known[static_cast<std::size_t>(column)]) continue;
      places.push_back(static_cast<int>(k));
      unknown.push_back(column);
      known[static_cast<std::size_t>(column)] = true;
    }
    if (unknown.empty()) continue;
    const MatrixXd A = joint->A();
    const VectorXd rest = joint->b() - A * joint->restricted(values);
    const MatrixXd of_unknown = A(Eigen::all, places);
    values(unknown) = shortest_solution(of_unknown, rest);
  }
  return values;
}

}  // namespace flatdyn
