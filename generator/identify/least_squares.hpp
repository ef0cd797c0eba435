// SPDX-License-Identifier: GPL-2.0-or-later
// Base parameters from observations: weighted least squares by QR, (7.85) without its normal equations.
#pragma once

#include "identify/damped_solution.hpp"
#include "identify/observations.hpp"

namespace flatdyn {

struct EstimateOptions {
  // Directions of the column-scaled regressor whose singular value is below this part of the largest are damped.
  double damping = 1e-8;
};

struct Estimate {
  Eigen::VectorXd values;               // π_b
  Eigen::VectorXd standard_deviations;  // of each; infinite where a damped or hidden direction has a part in it
  Eigen::VectorXd singular_values;      // of the weighted regressor, columns scaled to unit norm, descending
  std::vector<DampedDirection> damped;
  std::vector<HiddenDirection> hidden;
  Eigen::VectorXd torque_deviations;  // σ_i of the torque of joint i, from the residuals; the weights are 1/σ_i
  // r × b: |root_information (π_b - values)| is the distance from the estimate in standard deviations. Damped
  // and hidden directions have no row: they cost nothing.
  Eigen::MatrixXd root_information;
  int iterations = 0;
  bool converged = false;

  double condition() const { return singular_values(0) / singular_values(singular_values.size() - 1); }
};

// Weights start equal and are set anew from each joint's residual until they change by less than 1e-9 (50 times at
// most). σ_i counts the degrees of freedom that the fit takes from joint i (its leverage). Where rank is short, the
// solution of least distance to `prior` is approached: damped least squares about it. Where noise hides a
// direction, by the sizes of `prior`, the solution stays near it, too. Throws Failure(input) where there
// are no more equations than unknowns, so that nothing is left to tell noise by.
Estimate estimate(const Observations& observations, const Eigen::VectorXd& prior, const EstimateOptions& options = {});

// What it says about the first `count` of its parameters whatever the others are: count².
Eigen::MatrixXd root_information_of_first(const Estimate& estimate, int count);

// The textbook's sequential procedure (7.4): from the tips to the base, joint by joint, each from its own row with the
// parameters that are known already moved to the right; of what the motion does not tell, `prior`. Errors of the tips'
// parameters go into all others: for comparison.
Eigen::VectorXd estimate_joint_by_joint(const Observations& observations, const Eigen::VectorXd& prior);

}  // namespace flatdyn
