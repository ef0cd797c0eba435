// SPDX-License-Identifier: GPL-2.0-or-later
// The fewest parameters that the model is linear in: π_b = K π with Y = Y_b K, K exact, Y_b of full column rank. Y_b is
// made of columns of Y; each kept parameter stands for itself and for multiples of others that act like it.
//
// What cannot be told apart is found link by link, from the tips to the base. Σ_j y_j φ_j vanishes for all motions if
// and only if the Lagrangian of those parameters is constant. Only body j and its rotor know of q_j and q̇_j, once the
// bodies behind it are dealt with, so a part φ of their parameters is redundant if and only if its energy does not
// depend on q_j and q̇_j: M_j, a linear space. Then it is the energy that φ has with joint j held at 0, as a part of the
// parent, and can be moved there. For a revolute joint in general position M_j is m, m l_z and Î_xx + Î_yy; for a
// prismatic one the six moments of inertia (Gautier and Khalil, 1990). Near the base, and where gravity does not act,
// bodies move less freely and M_j is larger: it is computed, not listed. Friction dissipates, so its parameters are
// always independent.
#pragma once

#include <map>
#include <vector>

#include "symbolic/parameters/parameters.hpp"

namespace flatdyn {

// Σ coefficient · π_index.
using ParameterForm = std::map<int, Number>;

// What a closed loop hides: Y shift = 0 where the loop is closed. Of parameters π, share·π is hidden.
struct LoopShift {
  ParameterForm shift, share;
};

// Where loops are closed, Y = Y_b K; at any other positions Y = Y_b K + Σ (Y shift) share.
struct BaseParameters {
  std::vector<int> columns;                // places in π of the kept parameters, ascending
  std::vector<ParameterForm> combination;  // row k of K; the coefficient of columns[k] is 1, of other kept ones 0
  std::vector<LoopShift> shifts{};

  int size() const { return static_cast<int>(columns.size()); }
};

// Of the model with the parameters of `set`. Kept are those that come first: joint by joint from the base, and within a
// joint in the order of kPreference.
BaseParameters base_parameters(const Mechanism& mechanism, ParameterSet set = ParameterSet::given);

// Which parameter of a body is rather kept than another.
inline constexpr Parameter kPreference[] = {
    Parameter::Izz, Parameter::Ixx, Parameter::Ixy, Parameter::Ixz, Parameter::Iyz, Parameter::mlx, Parameter::mly,
    Parameter::m,   Parameter::mlz, Parameter::Iyy, Parameter::Im,  Parameter::Fv,  Parameter::Fs};

// π_b of the mechanism: K π.
std::vector<Number> base_values(const Mechanism& mechanism, const BaseParameters& base);

// The same mechanism with π_b at the kept places and zeros elsewhere: its torques, B, C and g are those of any
// mechanism with these base parameters. `values` as from base_values(), or symbols.
Mechanism with_base_parameters(const Mechanism& mechanism, const BaseParameters& base,
                               const std::vector<Number>& values);

}  // namespace flatdyn
