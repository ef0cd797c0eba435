// SPDX-License-Identifier: GPL-2.0-or-later
// Variances, which are not negative, from sums that are linear in them.
#pragma once

#include <Eigen/Core>

namespace flatdyn {

struct FittedVariances {
  Eigen::VectorXd values;
  Eigen::MatrixXd covariance;  // of their errors
};

// The x from 0 to `most` that minimises xᵀ H x / 2 - hᵀ x and the distance from the `known` ones (0: not known), which
// are sure to a share of the variance itself: where the residuals are far larger than they say, they hardly count. Of
// the `optional` ones, which come first, those that are zero count as absent in the covariance. The last `joints` are
// noise of accelerations.
FittedVariances fitted_variances(const Eigen::MatrixXd& H, const Eigen::VectorXd& h, const Eigen::VectorXd& known,
                                 const Eigen::VectorXd& most, Eigen::Index optional, Eigen::Index joints);

}  // namespace flatdyn
