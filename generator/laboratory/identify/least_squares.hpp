// SPDX-License-Identifier: GPL-2.0-or-later
// Base parameters from observations, (7.85): weighted least squares by QR, without normal equations.
#pragma once

#include "laboratory/identify/damped_solution.hpp"
#include "laboratory/identify/residual_noise.hpp"

namespace flatdyn {

struct EstimateOptions {
  // Directions of the column-scaled regressor are damped if their singular value is below this share of the largest.
  double damping = 1e-8;
  // ∂Y/∂q̈. Null: noise of positions counts as noise of torques.
  AccelerationRows acceleration_rows = nullptr;
  // Takes off the values what noise of positions adds to them; else it counts in their deviations alone.
  bool compensates = true;
};

struct Estimate {
  Eigen::VectorXd values;               // π_b
  Eigen::VectorXd standard_deviations;  // infinite for a parameter with a part in a damped or hidden direction
  // Singular values of the weighted regressor, columns scaled to unit norm, descending
  Eigen::VectorXd singular_values;
  std::vector<DampedDirection> damped;
  std::vector<HiddenDirection> hidden;
  std::vector<NoisyDirection> noisy;
  bool is_compensated = false;          // for noise of positions
  double growth = 1;                    // Solution::growth
  Eigen::VectorXd compensation;         // what is taken off for noise of positions, or would be; empty without account
  std::vector<RepeatedMotion> motions;  // of the logs; empty without instants
  Eigen::VectorXd torque_deviations;    // σ_i of the torque of joint i, from the residuals; the weights are 1/σ_i
  // r × b: |root_information (π_b - values)| is the distance from the estimate in standard deviations. Damped and
  // hidden directions have no row: a deviation along them costs nothing.
  Eigen::MatrixXd root_information;
  Eigen::MatrixXd covariance;  // b²; finite also along directions that are not determined
  int iterations = 0;
  bool converged = false;

  double condition() const { return singular_values(0) / singular_values(singular_values.size() - 1); }
};

// Weights start equal and are reset from each joint's residual until they change by less than 1e-9, 50 times at most.
// σ_i takes account of the degrees of freedom that the fit takes from joint i (its leverage), and of the noise above
// the band, which counts as kRowsOfKnownNoise rows: few rows that are fitted exactly are not free of noise. Noise of
// positions is taken account of (noise_account.hpp). Where rank is short, damped least squares approaches the solution
// nearest to `prior`. Where noise hides a direction, judged by the sizes of `prior`, the solution stays near `prior`,
// too. Standard deviations follow from the noise that is left, with its correlation across time and joints
// (residual_noise.hpp), where the observations have instants; else it counts as white but for
// JointObservations::correlation. Throws Failure(input) unless there are more equations than unknowns, since nothing is
// left to estimate the noise from.
Estimate estimate(const Observations& observations, const Eigen::VectorXd& prior, const EstimateOptions& options = {});

// By joint: the share of its rows' degrees of freedom that a fit leaves whose coordinates are spread along `spread`.
// The fit takes more of them where noise is correlated, which is in `spread`. deviations: σ_i of the torques.
Eigen::VectorXd shares_of_freedom(const Observations& observations, const Eigen::MatrixXd& spread,
                                  const Eigen::VectorXd& deviations);

// The information on the first `count` parameters, whatever the others are: count².
Eigen::MatrixXd root_information_of_first(const Estimate& estimate, int count);

// The textbook's sequential procedure (7.4), for comparison: from the tips to the base, joint by joint, each from its
// own row, with the known parameters moved to the right-hand side. Parameters that the motion does not determine are
// taken from `prior`. Errors of the tips' parameters spread to all others. together: by equation, a number that
// consecutive equations have in common that are solved as one; empty: each by itself.
Eigen::VectorXd estimate_joint_by_joint(const Observations& observations, const Eigen::VectorXd& prior,
                                        const std::vector<int>& together = {});

}  // namespace flatdyn
