// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/singular_values.hpp"

#include <Eigen/SVD>

#include "laboratory/identify/triangular_factor.hpp"

namespace flatdyn {

SingularValues singular_values(const Eigen::MatrixXd& square) {
  const Eigen::JacobiSVD<Eigen::MatrixXd, Eigen::NoQRPreconditioner> svd(square,
                                                                         Eigen::ComputeFullU | Eigen::ComputeFullV);
  return {svd.matrixU(), svd.singularValues(), svd.matrixV()};
}

SingularValues singular_values_of_tall(const Eigen::MatrixXd& tall) {
  return singular_values(triangular_factor_of(tall));
}

}  // namespace flatdyn
