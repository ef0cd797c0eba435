// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/certify/motion_bounds.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "proof/certify/rounding.hpp"

namespace flatdyn {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Basis = MotionBasis;

// The spectral norm: the root of the largest eigenvalue of M Mᵀ, or of Mᵀ M if that is smaller.
double spectral_norm(const MatrixXd& M) {
  if (M.rows() == 1 || M.cols() == 1) return M.norm();
  const MatrixXd gram = M.rows() < M.cols() ? MatrixXd(M * M.transpose()) : MatrixXd(M.transpose() * M);
  if (gram.rows() == 2) {
    return std::sqrt((gram.trace() + std::hypot(gram(0, 0) - gram(1, 1), 2 * gram(0, 1))) / 2);
  }
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(gram, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, eigen.eigenvalues().maxCoeff()));
}

// The largest length of the vector of all uᵀ M_r w, for unit vectors u and w.
double bilinear_norm(const std::vector<Matrix3d>& forms) {
  double squares = 0;
  MatrixXd all(static_cast<Index>(forms.size()), 9);
  for (Index r = 0; r < all.rows(); ++r) {
    const Matrix3d& form = forms[static_cast<std::size_t>(r)];
    const double norm = spectral_norm(form);
    squares += norm * norm;
    all.row(r) = form.reshaped().transpose();
  }
  return all.rows() == 1 ? std::sqrt(squares) : std::min(std::sqrt(squares), spectral_norm(all));
}

Matrix3d skew_of(const Eigen::Vector3d& a) {
  Matrix3d result;
  result << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return result;
}

// The matrix Q of the products in a row, xᵀ Q x with x = (ω, q̇_i).
Eigen::Matrix4d quadratic_form(const VectorXd& row) {
  Eigen::Matrix4d Q = Eigen::Matrix4d::Zero();
  Index place = Basis::kProducts;
  for (Index i = 0; i < 4; ++i) {
    for (Index j = i; j < 4; ++j) {
      Q(i, j) += row(place) / 2;
      Q(j, i) += row(place) / 2;
      ++place;
    }
  }
  return Q;
}

double length_of(const Vec3& v) {
  return std::hypot(nearest_double(v[0]), nearest_double(v[1]), nearest_double(v[2])) * kRoundingMargin;
}

}  // namespace

MotionBounds::MotionBounds(const Mechanism& mechanism, const InputLimits& limits) : base_(mechanism.base_bodies() - 1) {
  if (mechanism.floating_base) {
    add_base(limits);
  } else {
    of_base_ = length_of(mechanism.gravity);
  }
  for (int i = base_ + 1; i < mechanism.body_count(); ++i) {
    rates_.push_back(limits({with_base(InputKind::qd, mechanism.floating_base), i}));
    accelerations_.push_back(limits({with_base(InputKind::qdd, mechanism.floating_base), i}));
    const Body& body = mechanism.bodies[static_cast<std::size_t>(i)];
    links_.push_back(body.parent < 0 ? Link{} : after(body.parent, body));
  }
}

// The motion of a floating base, as that of its last body.
void MotionBounds::add_base(const InputLimits& limits) {
  const auto length = [&limits](InputKind kind, int first) {
    const double x = limits({kind, first}), y = limits({kind, first + 1}), z = limits({kind, first + 2});
    return std::hypot(x, y, z) * kRoundingMargin;
  };
  constexpr int kAngular = 3;
  rates_.assign(static_cast<std::size_t>(base_ + 1), length(InputKind::v, kAngular));
  accelerations_.assign(rates_.size(), length(InputKind::a, kAngular));
  links_.resize(rates_.size());
  of_base_ =
      (length(InputKind::a, 0) + rates_.back() * length(InputKind::v, 0) + length(InputKind::g_b, 0)) * kRoundingMargin;
}

// The joints on the path to the body, which is moved by a joint of `link`.
MotionBounds::Link MotionBounds::after(int link, const Body& body) const {
  Link result = links_[static_cast<std::size_t>(link)];
  for (double& lever : result.lever) lever = (lever + length_of(body.p)) * kRoundingMargin;
  result.before.push_back(link);
  // A displacement along a joint's axis has no moment arm; a base turns about any axis.
  const Number along = link == base_ ? body.p[2] : Number(0);
  result.lever.push_back(length_of({body.p[0], body.p[1], along}));
  return result;
}

double MotionBounds::of_motion(int link, const MatrixXd& rows) const {
  const Link& of = links_[static_cast<std::size_t>(link)];
  const double qd = rates_[static_cast<std::size_t>(link)], qdd = accelerations_[static_cast<std::size_t>(link)];
  const MatrixXd A = rows.middleCols<3>(Basis::kAngular), B = rows.middleCols<3>(Basis::kLinear),
                 W = rows.middleCols<3>(Basis::kOmega);
  std::vector<Matrix3d> squares, pairs;
  MatrixXd own_pairs(rows.rows(), 3);
  VectorXd own_square(rows.rows());
  for (Index r = 0; r < rows.rows(); ++r) {
    const Eigen::Matrix4d Q = quadratic_form(rows.row(r));
    squares.emplace_back(Q.topLeftCorner<3, 3>());
    pairs.emplace_back(2 * squares.back() - skew_of(A.row(r)));
    own_pairs.row(r) = pairs.back().col(2) + 2 * Q.col(3).head<3>();
    own_square(r) = Q(2, 2) + 2 * Q(2, 3) + Q(3, 3);
  }
  const double of_A = spectral_norm(A), of_B = spectral_norm(B), of_W = spectral_norm(W);
  const double of_squares = bilinear_norm(squares), of_pairs = bilinear_norm(pairs);
  if (link == base_) {
    return (rows.col(Basis::kOne).norm() + of_B * of_base_ + of_A * qdd + of_W * qd + of_squares * qd * qd) *
           kRoundingMargin;
  }
  double result = rows.col(Basis::kOne).norm() + of_B * of_base_ + qdd * (A.col(2) + rows.col(Basis::kOwn)).norm() +
                  qd * (W.col(2) + rows.col(Basis::kRate)).norm() + qd * qd * own_square.norm();
  const double of_own_pairs = spectral_norm(own_pairs);
  for (std::size_t b = 0; b < of.before.size(); ++b) {
    const auto joint = static_cast<std::size_t>(of.before[b]);
    const double rate = rates_[joint], lever = of_B * of.lever[b];
    result += accelerations_[joint] * (of_A + lever) + rate * of_W + rate * rate * (of_squares + lever) +
              rate * qd * of_own_pairs;
    for (std::size_t a = 0; a < b; ++a) {
      result += rates_[static_cast<std::size_t>(of.before[a])] * rate * (of_pairs + 2 * lever);
    }
  }
  return result * kRoundingMargin;
}

double MotionBounds::of_axis(int joint, int link, const MatrixXd& rows) const {
  const MatrixXd A = rows.middleCols<3>(Basis::kAxis), B = rows.middleCols<3>(Basis::kLever);
  if (joint <= base_) return of_axis_of_base(joint, link, A, B) * kRoundingMargin;
  if (joint == link) return A.col(2).norm() * kRoundingMargin;
  return (spectral_norm(A) + spectral_norm(B) * lever_of(joint, link)) * kRoundingMargin;
}

// A floating base slides along its first three axes, and turns about the others.
double MotionBounds::of_axis_of_base(int joint, int link, const MatrixXd& A, const MatrixXd& B) const {
  constexpr int kSlides = 3;
  if (joint < kSlides) return link == base_ ? B.col(joint).norm() : spectral_norm(B);
  if (link == base_) return A.col(joint - kSlides).norm();
  return spectral_norm(A) + spectral_norm(B) * lever_of(base_, link);
}

double MotionBounds::lever_of(int joint, int link) const {
  const Link& of = links_[static_cast<std::size_t>(link)];
  const auto place = std::find(of.before.begin(), of.before.end(), joint);
  return of.lever[static_cast<std::size_t>(place - of.before.begin())];
}

}  // namespace flatdyn
