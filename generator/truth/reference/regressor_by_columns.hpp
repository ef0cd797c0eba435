// SPDX-License-Identifier: GPL-2.0-or-later
// Regressors from the recursive Newton–Euler reference: column k is its torque for the written robot with all
// parameters zero but π_k = 1. The mechanism only determines which frames the parameters refer to.
#pragma once

#include <array>
#include <vector>

#include "robot/model/mechanism.hpp"
#include "robot/model/states.hpp"
#include "truth/reference/reference_model.hpp"

namespace flatdyn {

enum class RegressorColumns {
  all,   // those of all parameters, parameter_indices()
  base,  // those of the base parameters
};

template <class S>
class RegressorReference {
 public:
  RegressorReference(const Mechanism& mechanism, const reference::Robot<S>& robot, const SymbolValues& symbols,
                     RegressorColumns columns);

  // Y or Y_b, n x columns; and that of the torques B q̈_r + C(q, q̇) q̇_r + g + friction at q̇_r.
  reference::MatrixX<S> matrix(const StateOf<S>& state) const;
  reference::MatrixX<S> adaptive_matrix(const StateOf<S>& state) const;

  // By column: the written robot with one parameter 1 and the others 0.
  const std::vector<reference::Robot<S>>& units() const { return units_; }
  // By column: the index of its parameter.
  const std::vector<int>& indices() const { return indices_; }
  // The units' columns, where a spherical joint's friction about one axis acts about that one only.
  reference::MatrixX<S> with_own_friction(reference::MatrixX<S> Y) const;

 private:
  std::vector<reference::Robot<S>> units_;
  std::vector<int> indices_;
  std::vector<int> only_rows_;  // by column: the only row that is not zero, -1: all may be other than zero
};

// By entry of the matrices: the sum of the absolute values of its terms (truth/reference/magnitude.hpp). First
// moments are pairs of point masses of ±1/2 kg at 1 m, which may count twice.
reference::MatrixX<double> magnitudes(const RegressorReference<double>& of, const State& state);
reference::MatrixX<double> adaptive_magnitudes(const RegressorReference<double>& of, const State& state);

// Y_s of the torques k q - k q_0 of all joints' springs.
template <class S>
class SpringRegressorReference {
 public:
  SpringRegressorReference(const Mechanism& mechanism, const reference::Robot<S>& robot);

  reference::MatrixX<S> matrix(const StateOf<S>& state) const;

  // By joint: the written robot without parameters but a spring of the stiffness 1 that is relaxed at 0, and at 1.
  const std::vector<std::array<reference::Robot<S>, 2>>& units() const { return units_; }

 private:
  std::vector<std::array<reference::Robot<S>, 2>> units_;
};

reference::MatrixX<double> magnitudes(const SpringRegressorReference<double>& of, const State& state);

// π_b, and the sums of the absolute values of its terms.
template <class S>
struct BaseValues {
  std::vector<S> values, magnitudes;
};
template <class S>
BaseValues<S> base_values_of(const Mechanism& mechanism, const SymbolValues& symbols);

extern template class RegressorReference<double>;
extern template class RegressorReference<Real50>;
extern template class SpringRegressorReference<double>;
extern template class SpringRegressorReference<Real50>;

extern template BaseValues<double> base_values_of(const Mechanism&, const SymbolValues&);
extern template BaseValues<Real50> base_values_of(const Mechanism&, const SymbolValues&);

}  // namespace flatdyn
