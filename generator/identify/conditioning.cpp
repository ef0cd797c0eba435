// SPDX-License-Identifier: GPL-2.0-or-later
#include "identify/conditioning.hpp"

#include <limits>

#include "identify/singular_values.hpp"

namespace flatdyn {
namespace {

using Eigen::ArrayXd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// The power of the norms that stand in for largest and smallest.
constexpr double kNormPower = 16;

// A column of zeros stays one.
VectorXd inverse_lengths(const MatrixXd& matrix) {
  return matrix.colwise().norm().cwiseMax(std::numeric_limits<double>::min()).cwiseInverse();
}

double ratio(const VectorXd& singular_values) {
  return singular_values(0) / singular_values(singular_values.size() - 1);
}

}  // namespace

Conditioning conditioning(const MatrixXd& regressor) {
  const auto scaled = singular_values_of_tall(regressor * inverse_lengths(regressor).asDiagonal());
  return {ratio(scaled.s), ratio(singular_values_of_tall(regressor).s), scaled.V.rightCols<1>()};
}

// With Ȳ = Y D, D the inverse lengths, Ȳ = U Σ Vᵀ, and f the function of the singular values:
//   dσ_i = u_iᵀ dY D v_i − σ_i Σ_j v_ij² D_j² y_jᵀ dy_j
// The second term is the change of D. U is not needed, as U = Ȳ V Σ⁻¹.
double smooth_log_condition(const MatrixXd& regressor, MatrixXd* slope) {
  const VectorXd d = inverse_lengths(regressor);
  const MatrixXd scaled = regressor * d.asDiagonal();
  const auto svd = singular_values_of_tall(scaled);
  const ArrayXd s = svd.s.array().max(std::numeric_limits<double>::epsilon());
  const double largest = s(0), smallest = s(s.size() - 1);
  const ArrayXd up = (s / largest).pow(kNormPower), down = (smallest / s).pow(kNormPower);
  if (slope != nullptr) {
    const ArrayXd by_log = up / up.sum() - down / down.sum();  // df / d ln σ_i
    const MatrixXd& v = svd.V;
    const MatrixXd middle = v * (by_log / s.square()).matrix().asDiagonal() * v.transpose();
    const VectorXd of_lengths = (v.cwiseAbs2() * by_log.matrix()).cwiseProduct(d.cwiseAbs2());
    *slope = scaled * middle * d.asDiagonal();
    *slope -= regressor * of_lengths.asDiagonal();
  }
  return std::log(largest / smallest) + (std::log(up.sum()) + std::log(down.sum())) / kNormPower;
}

}  // namespace flatdyn
