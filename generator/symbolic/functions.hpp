// SPDX-License-Identifier: GPL-2.0-or-later
// The functions that flatdyn knows, and their derivation from a mechanism (recursive route).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "graph/function.hpp"
#include "model/mechanism.hpp"
#include "symbolic/regroup.hpp"

namespace flatdyn {

// Those of which the cheapest is taken.
using Groupings = std::span<const Grouping>;

// One row per function: its name, one line of help, and how it is derived.
struct FunctionEntry {
  const char* name;
  const char* summary;
  const char* equation;
  Function (*derive)(const Mechanism&, Groupings);
  // Another formulation of the same, where which one costs less depends on the robot; not every robot has it.
  std::optional<Function> (*alternative)(const Mechanism&, Groupings) = nullptr;
  // Left out unless asked for by name: the regressors serve identification and adaptive control, and are larger than
  // all other functions of a controller together.
  bool on_request = false;
};

// In the order in which they are emitted: inverse_dynamics, inverse_dynamics_tip_force, inertia_matrix, christoffel,
// coriolis_matrix, gravity, bias, forward_dynamics, kinetic_energy, potential_energy, forward_kinematics, jacobian,
// jacobian_dot_qd; then on request inverse_dynamics_derivatives, forward_dynamics_derivatives, regressor,
// base_regressor, base_parameters, inverse_dynamics_base, adaptive_regressor.
const std::vector<FunctionEntry>& function_table();

// Throws Failure(usage) for the name of no function, and for no link of the robot.
void check_function_name(const Mechanism& mechanism, const std::string& name);

// By name, in every formulation that there is; also "forward_kinematics:LINK", "jacobian:LINK" and
// "jacobian_dot_qd:LINK" for any named link. Throws as check_function_name does.
std::vector<Function> formulations(const Mechanism& mechanism, const std::string& name,
                                   Groupings groupings = kGroupings);

// The first of them.
Function derive_function(const Mechanism& mechanism, const std::string& name, Groupings groupings = kGroupings);

}  // namespace flatdyn
