// SPDX-License-Identifier: GPL-2.0-or-later
// Base parameters by instrumental variables: Σ Z_iᵀ w_i (Y_i π - τ_i) = 0, with Z_i the rows of a motion that has no
// part in the noise of the measured one. Noise in Y then makes no bias, whatever its size.
#pragma once

#include "identify/least_squares.hpp"
#include "identify/torque_equations.hpp"

namespace flatdyn {

// Sums Z_iᵀ Y_i and Z_iᵀ τ_i by equation.
class InstrumentSums {
 public:
  explicit InstrumentSums(const EquationModel& equations);

  void add(const FilteredEquations& each);

  // The solution in the directions that the least squares estimate tells, with its weights; elsewhere it stays that
  // one. observations: those of the same equations, with instruments.
  Estimate estimate(const Observations& observations, const Estimate& least_squares,
                    const AccelerationRows& acceleration_rows) const;

 private:
  const EquationModel& equations_;
  std::vector<Eigen::MatrixXd> products_;  // Z_iᵀ Y_i
  std::vector<Eigen::VectorXd> right_;     // Z_iᵀ τ_i
};

}  // namespace flatdyn
