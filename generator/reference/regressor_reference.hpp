// SPDX-License-Identifier: GPL-2.0-or-later
// Regressors from the recursive Newton–Euler reference: column k is its torque for the written robot with all
// parameters zero but π_k = 1. The mechanism only tells which frames the parameters refer to.
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
  // `function`: a function of the parameters; "regressor" has all columns, the others have those of the base
  // parameters.
  RegressorReference(const Mechanism& mechanism, const reference::Robot<S>& robot, const SymbolValues& symbols,
                     const std::string& function);

  // The function's entries: Y, Y_b, τ = Y_b π_b, or π_b.
  std::vector<S> values(const StateOf<S>& state) const;

  // Y_b or Y itself, n x columns.
  reference::MatrixX<S> matrix(const StateOf<S>& state) const;

  // π_b; base_magnitudes() are the sums of the absolute values of its terms.
  const std::vector<S>& base_values() const { return base_values_; }
  const std::vector<S>& base_magnitudes() const { return base_magnitudes_; }

  const std::string& function() const { return function_; }
  // By column: the written robot with one parameter 1 and the others 0.
  const std::vector<reference::Robot<S>>& units() const { return units_; }

 private:
  std::string function_;
  std::vector<reference::Robot<S>> units_;
  std::vector<S> base_values_, base_magnitudes_;  // for base_parameters only
};

// By entry: the sum of the absolute values of its terms (reference/magnitude.hpp). First moments are pairs of
// point masses of ±1/2 kg at 1 m, which may count twice.
std::vector<double> magnitudes(const RegressorReference<double>& of, const State& state);

extern template class RegressorReference<float>;
extern template class RegressorReference<double>;
extern template class RegressorReference<Real50>;

}  // namespace flatdyn
