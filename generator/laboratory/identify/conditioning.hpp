// SPDX-License-Identifier: GPL-2.0-or-later
// A measure of how well the stacked regressor of a motion separates the parameters. Singular values come from the
// triangular factor of a QR decomposition, never from YᵀY, which would square the condition number.
#pragma once

#include <Eigen/Core>

namespace flatdyn {

struct Conditioning {
  double relative = 0;  // condition number, every column divided by its length in other motions
  double scaled = 0;    // condition number, every column at unit length
  double unscaled = 0;  // condition number of the regressor as it is
  // The unit combination of parameters that the motion shows least, with columns scaled as for `relative`.
  Eigen::VectorXd weakest;
  // Standard deviations of the parameters if every entry of τ has noise of standard deviation 1.
  Eigen::VectorXd standard_deviations;
};

// regressor: at least as many rows as columns, or the triangular factor of such a matrix; lengths: the columns' lengths
// in other motions, positive.
Conditioning conditioning(const Eigen::MatrixXd& regressor, const Eigen::VectorXd& lengths);

// The logarithm of the root mean square of 1/σ_i, which measures the standard deviations of the coefficients of the
// columns, plus a quarter of ln σ_1. A smooth norm, slightly larger, replaces σ_1. `slope`, if not null, gets the
// derivative by each entry of the matrix.
double excitation_cost(const Eigen::MatrixXd& matrix, Eigen::MatrixXd* slope);

}  // namespace flatdyn
