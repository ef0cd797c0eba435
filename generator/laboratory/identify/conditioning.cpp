// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/conditioning.hpp"

#include <limits>

#include "laboratory/identify/singular_values.hpp"

namespace flatdyn {
namespace {

using Eigen::ArrayXd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// The power of the norm that approximates the largest singular value.
constexpr double kNormPower = 16;
// The weight of the largest singular value: 1 gives a condition number, which motions lower by moving less; 0 gives the
// standard deviations alone.
constexpr double kOfLargest = 0.25;

// The inverse of each column's length; a column of zeros stays zero when multiplied by it.
VectorXd inverse_lengths(const MatrixXd& matrix) {
  return matrix.colwise().norm().cwiseMax(std::numeric_limits<double>::min()).cwiseInverse();
}

double ratio(const VectorXd& singular_values) {
  return singular_values(0) / singular_values(singular_values.size() - 1);
}

}  // namespace

Conditioning conditioning(const MatrixXd& regressor, const VectorXd& lengths) {
  const auto relative = singular_values_of_tall(regressor * lengths.cwiseInverse().asDiagonal());
  const auto scaled = singular_values_of_tall(regressor * inverse_lengths(regressor).asDiagonal());
  const MatrixXd spread = relative.V * relative.s.cwiseInverse().asDiagonal();
  return {ratio(relative.s), ratio(scaled.s), ratio(singular_values_of_tall(regressor).s), relative.V.rightCols<1>(),
          spread.rowwise().norm().cwiseQuotient(lengths)};
}

// With A = U Σ Vᵀ, dσ_i = u_iᵀ dA v_i. U is not needed, since U = A V Σ⁻¹.
double excitation_cost(const MatrixXd& matrix, MatrixXd* slope) {
  const auto svd = singular_values_of_tall(matrix);
  const ArrayXd s = svd.s.array().max(std::numeric_limits<double>::epsilon() * svd.s(0));
  const double largest = s(0), smallest = s(s.size() - 1);
  const ArrayXd up = (s / largest).pow(kNormPower), down = (smallest / s).square();
  if (slope != nullptr) {
    const ArrayXd by_log = kOfLargest * up / up.sum() - down / down.sum();  // d cost / d ln σ_i
    *slope = matrix * (svd.V * (by_log / s.square()).matrix().asDiagonal() * svd.V.transpose());
  }
  return std::log(down.mean()) / 2 - std::log(smallest) +
         kOfLargest * (std::log(largest) + std::log(up.sum()) / kNormPower);
}

}  // namespace flatdyn
