// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/link_shape.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace flatdyn {
namespace {

using Eigen::Matrix4d;

constexpr double kSquareRootOf2 = std::numbers::sqrt2;

// The ten inertial parameters of (7.77) from the pseudo-inertia: Î = tr(Σ) E - Σ.
void inertial_entries(const Matrix4d& P, double* ten) {
  const double trace = P.topLeftCorner<3, 3>().trace();
  ten[0] = P(3, 3);
  for (int k = 0; k < 3; ++k) ten[1 + k] = P(k, 3);
  int at = 4;
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j) ten[at++] = (i == j ? trace : 0) - P(i, j);
  }
}

double divergence_of(double multiple) { return multiple - 1 - std::log(multiple); }

}  // namespace

Matrix4d symmetric_matrix(const double* ten) {
  Matrix4d X;
  for (int i = 0, at = 0; i < 4; ++i) {
    for (int j = 0; j <= i; ++j, ++at) X(i, j) = X(j, i) = i == j ? ten[at] : ten[at] / kSquareRootOf2;
  }
  return X;
}

void coordinates_of(const Matrix4d& symmetric, double* ten) {
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j <= i; ++j) *ten++ = i == j ? symmetric(i, j) : symmetric(i, j) * kSquareRootOf2;
  }
}

void LinkShape::parameters(double* pi) const {
  const Matrix4d root = L * S;
  inertial_entries(root * root.transpose(), pi);
  for (int k = 0; k < kOthers; ++k) pi[kInertialPerBody + k] = others[k] * multiples[k];
}

LinkShape::Matrix LinkShape::changes() const {
  Matrix columns = Matrix::Zero();
  const Matrix4d root = L * S;
  double unit[kInertialPerBody] = {};
  for (int k = 0; k < kInertialPerBody; ++k) {
    unit[k] = 1;
    inertial_entries(root * symmetric_matrix(unit) * root.transpose(), columns.col(k).data());
    unit[k] = 0;
  }
  for (int k = 0; k < kOthers; ++k) columns(kInertialPerBody + k, kInertialPerBody + k) = others[k] * multiples[k];
  return columns;
}

double LinkShape::divergence() const {
  double sum = divergence_from_file();
  for (int k = 0; k < kOthers; ++k) sum += in_file[k] ? 0 : divergence_of(multiples[k]);
  return sum;
}

double LinkShape::divergence_from_file() const {
  double sum = S.squaredNorm() - 4 - 2 * S.diagonal().array().log().sum();
  for (int k = 0; k < kOthers; ++k) sum += in_file[k] ? divergence_of(multiples[k]) : 0;
  return std::max(sum, 0.0);  // rounding can make the sum negative
}

LinkShape::Vector LinkShape::gradient() const {
  Vector result;
  coordinates_of(S.transpose() * S - Matrix4d::Identity(), result.data());
  for (int k = 0; k < kOthers; ++k) result(kInertialPerBody + k) = multiples[k] - 1;
  return result;
}

void LinkShape::move(const double* y) {
  S = S * Eigen::LLT<Matrix4d>(Matrix4d(Matrix4d::Identity() + symmetric_matrix(y))).matrixL();
  for (int k = 0; k < kOthers; ++k) multiples[k] *= 1 + y[kInertialPerBody + k];
}

}  // namespace flatdyn
