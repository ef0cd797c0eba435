// SPDX-License-Identifier: GPL-2.0-or-later
// Results of an identification as files for other programs.
#pragma once

#include <string>

#include "derivation/notation/combination_text.hpp"
#include "laboratory/identify/identification.hpp"

namespace flatdyn {

// The covariance of the estimate: a heading with the names of the parameters, then one row per parameter, in SI units.
// A parameter that the motion does not determine has no entries.
std::string covariance_csv(const TorqueEquations& equations, const Estimate& estimate);

// A Python module with names, combinations, values, deviations and covariance of the parameters, and arrays() of NumPy.
std::string results_module(const TorqueEquations& equations, const Identification& found, ParameterFrames frames);

// Collects the filtered signals of logs, one row per instant: log (counted from 1), t, q, q̇, q̈, then by joint the
// torque, that of the model, and whether the row was used; the residual is their difference.
class SignalTable {
 public:
  SignalTable(const TorqueEquations& equations, Eigen::VectorXd values);

  void add(const FilteredEquations& filtered, int log);
  const std::string& csv() const { return text_; }

 private:
  const TorqueEquations& equations_;
  Eigen::VectorXd values_;
  std::string text_;
};

}  // namespace flatdyn
