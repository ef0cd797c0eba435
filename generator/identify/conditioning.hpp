// SPDX-License-Identifier: GPL-2.0-or-later
// How well the stacked regressor of a motion separates the parameters. Singular values come from the triangular factor
// of a QR decomposition, never from YᵀY, which would square the condition number.
#pragma once

#include <Eigen/Core>

namespace flatdyn {

struct Conditioning {
  double scaled = 0;        // condition number with every column at unit length
  double unscaled = 0;      // as it is
  Eigen::VectorXd weakest;  // of the scaled columns: the combination that the motion shows least, unit length
};

// rows ≥ columns.
Conditioning conditioning(const Eigen::MatrixXd& regressor);

// A smooth stand-in for ln(condition number) of the scaled columns, a little larger: the largest and the inverse of the
// smallest singular value replaced by norms of all of them. `slope`, if given, gets the derivative by each entry.
double smooth_log_condition(const Eigen::MatrixXd& regressor, Eigen::MatrixXd* slope);

}  // namespace flatdyn
