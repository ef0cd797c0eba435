// SPDX-License-Identifier: GPL-2.0-or-later
// Least squares where the data do not tell all parameters: what they do not tell stays at, or near, what is known
// before.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace flatdyn {

// A combination of parameters, of unit length where every parameter counts by the norm of its column.
struct DampedDirection {
  double relative_singular_value = 0;
  Eigen::VectorXd components;  // b numbers
};

// A combination of parameters, of unit length in SI units.
struct HiddenDirection {
  double standard_deviation = 0;
  Eigen::VectorXd components;  // b numbers
};

// For rows that are weighted, so that noise has standard deviation 1.
struct Solution {
  Eigen::VectorXd values;
  // values = prior + spread coordinates, damped directions apart; the coordinates have covariance 1.
  Eigen::MatrixXd spread;
  Eigen::VectorXd coordinates;
  Eigen::MatrixXd root_information;  // r × b: root_information (π - values) has covariance 1, r ≤ b
  std::vector<bool> told;            // parameters that no direction below has a part in
  Eigen::VectorXd singular_values;   // columns scaled to unit norm, descending
  std::vector<DampedDirection> damped;
  std::vector<HiddenDirection> hidden;
};

// factor: (b + 1)², upper triangular, of [A b]. Where a relative singular value of the column-scaled A is below
// `damping`, damped least squares about `prior`.
Solution damped_solution(const Eigen::MatrixXd& factor, const Eigen::VectorXd& prior, double damping);

// Columns of a joint that is held are not zero but noise of its encoder: no singular value is small, and the solution
// goes anywhere. A direction counts as hidden if its standard deviation is larger than `plausible`, what parameters can
// be at the most, and the data do not clearly contradict the prior along it; there the solution becomes that of a prior
// with this standard deviation, and parameters that a tenth of it may be missing in are not told.
void hide_noise(Solution& solution, double plausible);

}  // namespace flatdyn
