// SPDX-License-Identifier: GPL-2.0-or-later
// Least squares for data that do not determine all parameters: those that they do not determine stay at, or near, their
// prior values.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "laboratory/identify/repetition.hpp"

namespace flatdyn {

// A damped combination of parameters; of unit length when every parameter is scaled by the norm of its column.
struct DampedDirection {
  double relative_singular_value = 0;
  Eigen::VectorXd components;  // b numbers
};

// A combination of parameters hidden by noise; of unit length in SI units.
struct HiddenDirection {
  double standard_deviation = 0;
  Eigen::VectorXd components;  // b numbers
};

// A combination of parameters and how much of what the data say of it is noise of positions.
struct NoisyDirection {
  static constexpr double kMost = 0.5;

  double share = 0;            // of the information: 0 … 1, or more where that noise counts as larger than it is
  Eigen::VectorXd components;  // b numbers, as long as the standard deviation that white noise of the torques makes

  // Whether too little is left that is sure.
  bool is_open() const { return share > kMost; }
};

// The solution of weighted equations, whose noise has standard deviation 1.
struct Solution {
  Eigen::VectorXd values;
  // values = prior + spread coordinates, up to damped directions; the coordinates have covariance 1.
  Eigen::MatrixXd spread;
  Eigen::VectorXd coordinates;
  Eigen::MatrixXd root_information;  // r × b: root_information (π - values) has covariance 1, r ≤ b
  std::vector<bool> determined;      // true for parameters without a part in the directions below
  Eigen::VectorXd singular_values;   // columns scaled to unit norm, descending
  std::vector<DampedDirection> damped;
  std::vector<HiddenDirection> hidden;
  std::vector<NoisyDirection> noisy;  // all directions of the information, by ascending share
  Eigen::VectorXd compensation;       // what is taken off the values for noise of positions, or would be
  bool is_compensated = false;        // whether it is taken off
  double growth = 1;                  // the most by which it makes the residual (rms) of a joint grow, times
  std::vector<RepeatedMotion> motions;
  Eigen::MatrixXd open;  // directions of which the data are mostly noise of positions: one column each
};

// factor: the upper triangular factor of [A b], (b + 1)². Where a relative singular value of the column-scaled A is
// below `damping`, the solution is damped least squares about `prior`.
Solution damped_solution(const Eigen::MatrixXd& factor, const Eigen::VectorXd& prior, double damping);

// The columns of a joint that is held hold encoder noise instead of zeros: no singular value is small, and the solution
// may go anywhere. A direction counts as hidden if its standard deviation is larger than `plausible`, the largest size
// that parameters can have, and the data do not clearly contradict the prior along it. Along hidden directions the
// solution becomes that of a prior with standard deviation `plausible`. A parameter that keeps more than a tenth of
// `plausible` as uncertainty there counts as not determined.
void damp_hidden_directions(Solution& solution, double plausible);

// Directions that are left open are at the prior, whose standard deviation is `plausible` along them. A parameter of
// which more than a tenth of that is uncertain counts as not determined.
void leave_open(Solution& solution, double plausible);

}  // namespace flatdyn
