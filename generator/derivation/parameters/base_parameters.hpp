// SPDX-License-Identifier: GPL-2.0-or-later
// Base parameters: the smallest set in which the model is linear. π_b = K π with Y = Y_b K, K exact, Y_b of full column
// rank. The columns of Y_b are columns of Y; each kept parameter represents itself and multiples of others with the
// same effect.
//
// Redundant parameters are found link by link, from the tips to the base. Σ_j y_j φ_j vanishes for all motions if and
// only if the Lagrangian of those parameters is constant. Once the descendants of body j have been processed, only body
// j and its rotor depend on q_j and q̇_j, so a part φ of their parameters is redundant if and only if its energy does
// not depend on q_j and q̇_j. These φ form a linear space M_j. The energy of such a part is the one that it has with
// joint j held at 0, as a part of the parent, and so it can be moved there. For a revolute joint in general position
// M_j is m, m l_z and Î_xx + Î_yy; for a prismatic one the six moments of inertia (Gautier and Khalil, 1990). Near the
// base, and where gravity does not act, bodies move less freely and M_j is larger, so it is computed rather than
// listed. A floating base keeps its ten. Friction dissipates, so its parameters are always independent.
#pragma once

#include <map>
#include <vector>

#include "derivation/parameters/parameters.hpp"

namespace flatdyn {

// A linear form in the parameters: Σ coefficient · π_index.
using ParameterForm = std::map<int, Number>;

// A parameter direction that a closed loop hides: Y shift = 0 where the loop is closed. The amount of it in π is
// share·π.
struct LoopShift {
  ParameterForm shift, share;
};

// Where loops are closed, Y = Y_b K; at other positions Y = Y_b K + Σ (Y shift) share.
struct BaseParameters {
  std::vector<int> columns;                // indices in π of the kept parameters, ascending
  std::vector<ParameterForm> combination;  // row k of K; the coefficient of columns[k] is 1, of other kept ones 0
  std::vector<LoopShift> shifts{};

  int size() const { return static_cast<int>(columns.size()); }
};

// The base parameters of the model with the parameters of `set`. Parameters that come first are kept: joint by joint
// from the base, and within a joint in the order of kPreference.
BaseParameters base_parameters(const Mechanism& mechanism, ParameterSet set = ParameterSet::given);

// The order in which the parameters of a body are preferred for being kept.
inline constexpr Parameter kPreference[] = {
    Parameter::Izz, Parameter::Ixx, Parameter::Ixy, Parameter::Ixz, Parameter::Iyz, Parameter::mlx, Parameter::mly,
    Parameter::m,   Parameter::mlz, Parameter::Iyy, Parameter::Im,  Parameter::Fv,  Parameter::Fs};

// The values π_b = K π of the mechanism.
std::vector<Number> base_values(const Mechanism& mechanism, const BaseParameters& base);

// The same mechanism with π_b at the kept places and zeros elsewhere: its torques, B, C and g are those of any
// mechanism with these base parameters. `values`: as from base_values(), or symbols.
Mechanism with_base_parameters(const Mechanism& mechanism, const BaseParameters& base,
                               const std::vector<Number>& values);

}  // namespace flatdyn
