// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/body_search.hpp"

#include <ceres/gradient_problem.h>
#include <ceres/gradient_problem_solver.h>
#include <glog/logging.h>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace flatdyn {
namespace {

using Eigen::Index;
using Eigen::Matrix4d;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// The share of the file's bodies in the result. Bodies that π_b makes flat stay positive definite in double by it.
constexpr double kOfTheFile = 1e-9;

// The terms of λ - log(1 + λ) beyond second order, and their derivative. λ is an eigenvalue of X, or the relative
// change of I_m, F_v or F_s.
double beyond_second_order(double lambda) { return lambda - std::log1p(lambda) - lambda * lambda / 2; }
double its_derivative(double lambda) { return -lambda * lambda / (1 + lambda); }

// The sum of beyond_second_order() over all links, where L S (E + X) Sᵀ Lᵀ are bodies; HUGE_VAL where they are not.
double divergence_beyond_second_order(const VectorXd& y, VectorXd& gradient) {
  double sum = 0;
  gradient.resize(y.size());
  for (Index at = 0; at < y.size(); at += kParametersPerJoint) {
    const Eigen::SelfAdjointEigenSolver<Matrix4d> X(symmetric_matrix(y.data() + at));
    const auto others = y.segment<LinkShape::kOthers>(at + kInertialPerBody);
    if (!(X.eigenvalues().minCoeff() > -1 && others.minCoeff() > -1)) return HUGE_VAL;
    sum += X.eigenvalues().unaryExpr(&beyond_second_order).sum() + others.unaryExpr(&beyond_second_order).sum();
    coordinates_of(
        X.eigenvectors() * X.eigenvalues().unaryExpr(&its_derivative).asDiagonal() * X.eigenvectors().transpose(),
        gradient.data() + at);
    gradient.segment<LinkShape::kOthers>(at + kInertialPerBody) = others.unaryExpr(&its_derivative);
  }
  return sum;
}

// The cost about the present links, up to a constant and the factor decrease(): |J y - wanted|² / 2 to second order,
// which is |x - newton|² / 2 in the coordinates x, plus the exact higher-order terms of the divergence. So Newton's
// step is a unit vector, as long as Ceres' first step.
class LocalCost : public ceres::FirstOrderFunction {
 public:
  LocalCost(const MatrixXd& J, const VectorXd& wanted, double weight) : weight_(weight) {
    const Eigen::HouseholderQR<MatrixXd> qr(J);
    newton_ = (qr.householderQ().transpose() * wanted).head(J.cols());
    R_ = qr.matrixQR().topRows(J.cols()).triangularView<Eigen::Upper>();
    decrease_ = newton_.squaredNorm();
    newton_ /= std::sqrt(decrease_);
  }

  // The decrease of the cost that Newton's step predicts.
  double decrease() const { return decrease_; }
  VectorXd y_of(const VectorXd& x) const { return std::sqrt(decrease_) * R_.triangularView<Eigen::Upper>().solve(x); }

  int NumParameters() const override { return static_cast<int>(newton_.size()); }
  bool Evaluate(const double* parameters, double* cost, double* gradient) const override {
    const Eigen::Map<const VectorXd> x(parameters, newton_.size());
    VectorXd of_divergence;
    const double divergence = divergence_beyond_second_order(y_of(x), of_divergence);
    *cost = (x - newton_).squaredNorm() / 2 + weight_ / decrease_ * divergence;
    if (!std::isfinite(*cost)) return false;  // not a body: the line search takes a shorter step
    if (gradient == nullptr) return true;
    const VectorXd in_x = R_.transpose().triangularView<Eigen::Lower>().solve(of_divergence);
    Eigen::Map<VectorXd>(gradient, x.size()) = x - newton_ + weight_ / std::sqrt(decrease_) * in_x;
    return true;
  }

 private:
  double weight_, decrease_ = 0;
  VectorXd newton_;
  MatrixXd R_;
};

LocalCost local_cost(const std::vector<LinkShape>& links, const MatrixXd& K, const VectorXd& residual, double weight) {
  const Index rows = K.rows(), size = K.cols();
  const double root = std::sqrt(weight);
  MatrixXd J(rows + size, size);
  VectorXd wanted(rows + size);
  J.bottomRows(size) = root * MatrixXd::Identity(size, size);
  wanted.head(rows) = -residual;
  Index at = 0;
  for (const LinkShape& link : links) {
    J.block(0, at, rows, kParametersPerJoint) = K.middleCols(at, kParametersPerJoint) * link.changes();
    wanted.segment(rows + at, kParametersPerJoint) = -root * link.gradient();
    at += kParametersPerJoint;
  }
  return {J, wanted, weight};
}

// The x that Ceres reaches; none if it finds nothing better than 0. Ceres stops where progress is slow: new coordinates
// then help more than what its quasi-Newton steps have learnt in these.
std::optional<VectorXd> minimised(const LocalCost& cost) {
  ceres::GradientProblemSolver::Options options;
  options.line_search_direction_type = ceres::BFGS;
  options.max_num_iterations = 300;
  options.max_num_line_search_step_size_iterations = 60;
  options.function_tolerance = 1e-3;
  options.parameter_tolerance = 1e-14;
  options.update_state_every_iteration = true;  // the best x counts, even if a later step fails
  options.logging_type = ceres::SILENT;
  FLAGS_minloglevel = google::GLOG_FATAL;  // Ceres warns even if it is silent
  const ceres::GradientProblem problem(new LocalCost(cost));
  VectorXd x = VectorXd::Zero(cost.NumParameters());
  double before = 0, after = 0;
  cost.Evaluate(x.data(), &before, nullptr);
  ceres::GradientProblemSolver::Summary summary;
  ceres::Solve(options, problem, x.data(), &summary);
  if (cost.Evaluate(x.data(), &after, nullptr) && after < before) return x;
  return std::nullopt;
}

}  // namespace

BodySearch::BodySearch(std::vector<LinkShape> links, const MatrixXd& K, const VectorXd& target)
    : links_(std::move(links)), file_(shapes()), target_(target - kOfTheFile * K * file_), K_((1 - kOfTheFile) * K) {}

VectorXd BodySearch::shapes() const {
  VectorXd pi(static_cast<Index>(links_.size()) * kParametersPerJoint);
  Index at = 0;
  for (const LinkShape& link : links_) {
    link.parameters(pi.data() + at);
    at += kParametersPerJoint;
  }
  return pi;
}

VectorXd BodySearch::bodies() const { return (1 - kOfTheFile) * shapes() + kOfTheFile * file_; }

double BodySearch::divergence() const {
  double sum = 0;
  for (const LinkShape& link : links_) sum += link.divergence();
  return sum;
}

double BodySearch::divergence_from_file() const {
  double sum = 0;
  for (const LinkShape& link : links_) sum += link.divergence_from_file();
  return sum;
}

// Lowers the weight of the divergence step by step: the last steps move only what π_b leaves open.
bool BodySearch::run() {
  constexpr double kLightest = 1e-3, kLighter = 0.1;
  double weight = std::max(1.0, residual().squaredNorm() / static_cast<double>(file_.size()));
  bool converged = improve(weight);
  while (weight > kLightest) {
    weight = std::max(kLighter * weight, kLightest);
    converged = improve(weight);
  }
  return converged;
}

// Minimises the cost at one weight, in new coordinates each time Ceres stops. Returns whether it converged.
bool BodySearch::improve(double weight) {
  constexpr int kMostRounds = 50;
  constexpr double kSmall = 1e-8, kOfTheCost = 1e-9;
  for (int round = 0; round < kMostRounds; ++round) {
    const double before = residual().squaredNorm() / 2 + weight * divergence();
    const LocalCost cost = local_cost(links_, K_, residual(), weight);
    if (cost.decrease() <= std::max(kSmall * weight, kOfTheCost * before)) return true;
    const std::optional<VectorXd> x = minimised(cost);
    if (!x) return false;
    const VectorXd y = cost.y_of(*x);
    for (std::size_t i = 0; i < links_.size(); ++i) links_[i].move(y.data() + i * kParametersPerJoint);
  }
  return false;
}

}  // namespace flatdyn
