// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/hypothesis.hpp"

#include <ceres/ceres.h>

#include <Eigen/Cholesky>

namespace flatdyn {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// The least |A π - b|², by normal equations with columns scaled to unit length.
class LinearFit {
 public:
  explicit LinearFit(WeightedEquations rows) : rows_(std::move(rows)) {
    constexpr double kRidge = 1e-10;  // directions that the rows leave open stay at 0
    const Index size = rows_.A.cols();
    MatrixXd H = MatrixXd::Zero(size, size);
    H.selfadjointView<Eigen::Lower>().rankUpdate(rows_.A.transpose());
    scale_ = H.diagonal().cwiseSqrt().cwiseMax(1e-150).cwiseInverse();
    H = scale_.asDiagonal() * H * scale_.asDiagonal();
    H.diagonal().array() += kRidge;
    cholesky_.compute(H);
    pi_ = solution(rows_.b);
    residual_ = rows_.A * pi_ - rows_.b;
  }

  const VectorXd& pi() const { return pi_; }
  const VectorXd& residual() const { return residual_; }
  VectorXd deviations() const {
    const MatrixXd root = cholesky_.matrixL().solve(MatrixXd(scale_.asDiagonal()));
    return root.colwise().norm();
  }
  VectorXd residual_with(const WeightedEquations& rows) const { return rows.A * pi_ - rows.b; }
  // The part of a column that no change of π makes.
  VectorXd across(const VectorXd& column) const { return column - rows_.A * solution(column); }

 private:
  VectorXd solution(const VectorXd& b) const {
    return scale_.cwiseProduct(cholesky_.solve(scale_.cwiseProduct(rows_.A.transpose() * b)));
  }

  WeightedEquations rows_;
  VectorXd scale_;
  Eigen::LLT<MatrixXd> cholesky_;
  VectorXd pi_, residual_;
};

// The derivatives of the residual by the unknowns, whatever π is.
MatrixXd derivatives_across(const Hypothesis& hypothesis, const VectorXd& x, const LinearFit& fit) {
  MatrixXd columns(fit.residual().size(), x.size());
  for (Index k = 0; k < x.size(); ++k) {
    const double step = hypothesis.unknowns[static_cast<std::size_t>(k)].step;
    const VectorXd change = step * VectorXd::Unit(x.size(), k);
    const VectorXd ahead = fit.residual_with(hypothesis.apply(x + change)),
                   behind = fit.residual_with(hypothesis.apply(x - change));
    columns.col(k) = fit.across((ahead - behind) / (2 * step));
  }
  return columns;
}

// The residual that is left of the rows by the best π, as a function of the unknowns.
class ProjectedResidual : public ceres::CostFunction {
 public:
  ProjectedResidual(const Hypothesis& hypothesis, Index unknowns, Index rows)
      : hypothesis_(hypothesis), unknowns_(unknowns) {
    set_num_residuals(static_cast<int>(rows));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(unknowns));
  }

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    using RowByRow = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const VectorXd x = Eigen::Map<const VectorXd>(parameters[0], unknowns_);
    const LinearFit fit(hypothesis_.apply(x));
    Eigen::Map<VectorXd>(residuals, num_residuals()) = fit.residual();
    if (jacobians == nullptr || jacobians[0] == nullptr) return true;
    Eigen::Map<RowByRow>(jacobians[0], num_residuals(), unknowns_) = derivatives_across(hypothesis_, x, fit);
    return true;
  }

 private:
  const Hypothesis& hypothesis_;
  Index unknowns_;
};

}  // namespace

HypothesisFit fit_of(WeightedEquations rows) {
  const LinearFit fit(std::move(rows));
  return {fit.residual().squaredNorm(), fit.pi(), fit.deviations()};
}

HypothesisFit fit_at(const Hypothesis& hypothesis, const VectorXd& x) {
  HypothesisFit fit = fit_of(hypothesis.apply(x));
  fit.x = x;
  return fit;
}

HypothesisFit fit_near(const Hypothesis& hypothesis, const VectorXd& start) {
  if (start.size() == 0) return fit_at(hypothesis, start);
  VectorXd x = start;
  ceres::Problem problem;
  const Index rows = hypothesis.apply(x).b.size();
  problem.AddResidualBlock(new ProjectedResidual(hypothesis, x.size(), rows), nullptr, x.data());
  for (int k = 0; k < static_cast<int>(x.size()); ++k) {
    problem.SetParameterLowerBound(x.data(), k, hypothesis.unknowns[static_cast<std::size_t>(k)].low);
    problem.SetParameterUpperBound(x.data(), k, hypothesis.unknowns[static_cast<std::size_t>(k)].high);
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.function_tolerance = 1e-10;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  return fit_at(hypothesis, x);
}

HypothesisFit best_fit(const Hypothesis& hypothesis) {
  HypothesisFit best = fit_at(hypothesis, hypothesis.starts.front());
  for (std::size_t k = 1; k < hypothesis.starts.size(); ++k) {
    HypothesisFit next = fit_at(hypothesis, hypothesis.starts[k]);
    if (next.cost < best.cost) best = std::move(next);
  }
  return best.x.size() == 0 ? best : fit_near(hypothesis, best.x);
}

MatrixXd information_on_unknowns(const Hypothesis& hypothesis, const VectorXd& x) {
  const MatrixXd columns = derivatives_across(hypothesis, x, LinearFit(hypothesis.apply(x)));
  return columns.transpose() * columns;
}

}  // namespace flatdyn
