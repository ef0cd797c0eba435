// SPDX-License-Identifier: GPL-2.0-or-later
// How well the stacked regressor of a motion separates the parameters. Singular values come from the triangular factor
// of a QR decomposition, never from YᵀY, which would square the condition number.
#pragma once

#include <Eigen/Core>

namespace flatdyn {

struct Conditioning {
  double relative = 0;  // condition number with every column divided by its length in other motions
  double scaled = 0;    // with every column at unit length
  double unscaled = 0;  // as it is
  // Of the columns as for `relative`: the combination that the motion shows least, of unit length.
  Eigen::VectorXd weakest;
  // Of the parameters, where every entry of τ has noise of standard deviation 1.
  Eigen::VectorXd standard_deviations;
};

// regressor: rows ≥ columns, or the triangular factor of such a one; lengths: of the columns in other motions,
// positive.
Conditioning conditioning(const Eigen::MatrixXd& regressor, const Eigen::VectorXd& lengths);

// ln of the root mean square of 1/σ_i, so of the standard deviations of what multiplies the columns, plus a quarter of
// ln σ_1, of which a norm stands in that is smooth and a little larger. `slope`, if given, gets the derivative by each
// entry.
double excitation_cost(const Eigen::MatrixXd& matrix, Eigen::MatrixXd* slope);

}  // namespace flatdyn
