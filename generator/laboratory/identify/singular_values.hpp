// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <Eigen/Core>

namespace flatdyn {

// matrix = U diag(s) Vᵀ, s descending.
struct SingularValues {
  Eigen::MatrixXd U;
  Eigen::VectorXd s;
  Eigen::MatrixXd V;
};

SingularValues singular_values(const Eigen::MatrixXd& square);

// The decomposition of a matrix with at least as many rows as columns, computed from its triangular factor; U is that
// of the factor.
SingularValues singular_values_of_tall(const Eigen::MatrixXd& tall);

}  // namespace flatdyn
