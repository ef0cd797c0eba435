// SPDX-License-Identifier: GPL-2.0-or-later
// Base parameters by instrumental variables: Σ Z_iᵀ w_i (Y_i π - τ_i) = 0. The rows Z_i are those of Y along the slow
// motion (FilteredEquations::instruments). Noise of q grows in accelerations with the fifth power of the band, so that
// the slow motion has about a thousandth of the noise that Y has: noise in Y then makes hardly any bias, whatever its
// size. It has nothing of the measured torques. (The motion of a model that is simulated under them, as an instrument,
// would have their noise in its accelerations, and shift all inertias by it.)
#pragma once

#include "laboratory/identify/least_squares.hpp"
#include "laboratory/identify/torque_equations.hpp"

namespace flatdyn {

// Sums Z_iᵀ Y_i and Z_iᵀ τ_i by equation.
class InstrumentSums {
 public:
  explicit InstrumentSums(const EquationModel& equations);

  void add(const FilteredEquations& each);

  // The solution in the directions that least squares determines, with its weights; elsewhere it stays near `prior`.
  // observations: those of the same equations, with instruments. Throws Failure(input) if the instruments do not
  // determine all of these directions.
  Estimate estimate(const Observations& observations, const Eigen::VectorXd& prior,
                    const EstimateOptions& options) const;

 private:
  const EquationModel& equations_;
  std::vector<Eigen::MatrixXd> products_;  // Z_iᵀ Y_i
  std::vector<Eigen::VectorXd> right_;     // Z_iᵀ τ_i
};

}  // namespace flatdyn
