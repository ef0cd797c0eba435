// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/certify/vector_bounds.hpp"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <cmath>
#include <complex>
#include <numbers>

namespace flatdyn {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// Qᵀ M. If there are no columns, Eigen would add an offset to a null pointer.
MatrixXd turned(const Eigen::ColPivHouseholderQR<MatrixXd>& qr, const MatrixXd& M) {
  return M.cols() == 0 ? M : MatrixXd(qr.householderQ().transpose() * M);
}
MatrixXd last_rows(const MatrixXd& M, Index rows) {
  return M.cols() == 0 ? MatrixXd(rows, 0) : MatrixXd(M.bottomRows(rows));
}

}  // namespace

double length_in_box(const MatrixXd& M) {
  if (M.size() == 0) return 0;
  return M.rows() == 1 ? M.cwiseAbs().sum() : std::sqrt((M.transpose() * M).cwiseAbs().sum());
}

MatrixXd bound_over_all_angles(const MatrixXd& C, const MatrixXd& S) {
  const Index rows = C.rows();
  const MatrixXd both = stacked(C, S);
  if (rows <= 1) return both;
  // In a basis Q of all combinations of φ that occur.
  const Index size = std::min(both.rows(), both.cols());
  const MatrixXd Q =
      Eigen::HouseholderQR<MatrixXd>(both.transpose()).householderQ() * MatrixXd::Identity(C.cols(), size);
  MatrixXcd Z(rows, size);
  Z.real() = C * Q;
  Z.imag() = S * Q;
  const Eigen::JacobiSVD<MatrixXcd> svd(Z.transpose() * Z, Eigen::ComputeFullV);
  const MatrixXcd root = svd.singularValues().cwiseSqrt().asDiagonal() * svd.matrixV().adjoint();
  MatrixXd N(2 * (rows + size), size);
  N << Z.real(), Z.imag(), root.real(), root.imag();
  return N * Q.transpose() / std::numbers::sqrt2;
}

GatheredRows gathered(const MatrixXd& chosen, const MatrixXd& others) {
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(chosen);
  const Index rank = (qr.matrixQR().diagonal().array().abs() > kNegligible).count();
  const MatrixXd of = turned(qr, chosen), rest = turned(qr, others);
  const Index below = of.rows() - rank;
  return {of.topRows(rank), rest.topRows(rank), last_rows(rest, below), length_in_box(last_rows(of, below))};
}

MatrixXd row_echelon(MatrixXd M) {
  Index row = 0;
  VectorXd essential, workspace(M.cols());
  for (Index column = 0; column < M.cols() && row < M.rows(); ++column) {
    const Index below = M.rows() - row;
    if (M.col(column).tail(below).norm() < kNegligible) continue;
    essential.resize(below - 1);
    double factor = 0, diagonal = 0;
    M.col(column).tail(below).makeHouseholder(essential, factor, diagonal);
    M.bottomRightCorner(below, M.cols() - column).applyHouseholderOnTheLeft(essential, factor, workspace.data());
    if (diagonal < 0) M.row(row) = -M.row(row);
    ++row;
  }
  return M.topRows(row);
}

MatrixXd columns(const MatrixXd& M, const std::vector<Index>& which) {
  MatrixXd result(M.rows(), static_cast<Index>(which.size()));
  for (Index k = 0; k < result.cols(); ++k) result.col(k) = M.col(which[static_cast<std::size_t>(k)]);
  return result;
}

MatrixXd stacked(const MatrixXd& a, const MatrixXd& b) {
  MatrixXd result(a.rows() + b.rows(), a.cols());
  if (result.size() > 0) result << a, b;
  return result;
}

MatrixXd block_diagonal(const MatrixXd& a, const MatrixXd& b) {
  MatrixXd result = MatrixXd::Zero(a.rows() + b.rows(), a.cols() + b.cols());
  result.topLeftCorner(a.rows(), a.cols()) = a;
  if (b.size() > 0) result.bottomRightCorner(b.rows(), b.cols()) = b;
  return result;
}

}  // namespace flatdyn
