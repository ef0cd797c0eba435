// SPDX-License-Identifier: GPL-2.0-or-later
#include "identify/singular_values.hpp"

#include <Eigen/QR>
#include <Eigen/SVD>

namespace flatdyn {

SingularValues singular_values(const Eigen::MatrixXd& square) {
  const Eigen::BDCSVD<Eigen::MatrixXd> svd(square, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return {svd.matrixU(), svd.singularValues(), svd.matrixV()};
}

SingularValues singular_values_of_tall(const Eigen::MatrixXd& tall) {
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(tall);
  return singular_values(qr.matrixQR().topRows(tall.cols()).triangularView<Eigen::Upper>());
}

}  // namespace flatdyn
