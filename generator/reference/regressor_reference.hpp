// SPDX-License-Identifier: GPL-2.0-or-later
// Regressors from the recursive Newton–Euler reference: column k is its torque for the written robot with all
// parameters zero but π_k = 1. The mechanism says only where the frames are that the parameters refer to.
#pragma once

#include <string>
#include <vector>

#include "graph/function.hpp"
#include "model/mechanism.hpp"
#include "model/states.hpp"
#include "reference/reference_model.hpp"

namespace flatdyn {

template <class S>
class RegressorReference {
 public:
  // For a function of the parameters: "regressor" with all columns, the others with those of the base parameters.
  RegressorReference(const Mechanism& mechanism, const reference::Robot<S>& robot, const SymbolValues& symbols,
                     const std::string& function);

  // The function's entries: Y, Y_b, τ = Y_b π_b, or π_b.
  std::vector<S> values(const StateOf<S>& state) const;

  // Y_b or Y itself: n x columns.
  reference::MatrixX<S> matrix(const StateOf<S>& state) const;

  // π_b, and the sums of the absolute values of its terms.
  const std::vector<S>& base_values() const { return base_values_; }
  const std::vector<S>& base_magnitudes() const { return base_magnitudes_; }

  const std::string& function() const { return function_; }
  // The written robot with one parameter 1 and the others 0, one per column.
  const std::vector<reference::Robot<S>>& units() const { return units_; }

 private:
  std::string function_;
  std::vector<reference::Robot<S>> units_;
  std::vector<S> base_values_, base_magnitudes_;  // for base_parameters only
};

// The sum of the absolute values of each entry's own terms (flatdyn/reference/magnitude.hpp). First moments are pairs
// of point masses of ±1/2 kg at 1 m, which can count twice.
std::vector<double> magnitudes(const RegressorReference<double>& of, const State& state);

extern template class RegressorReference<float>;
extern template class RegressorReference<double>;
extern template class RegressorReference<Real50>;

}  // namespace flatdyn
