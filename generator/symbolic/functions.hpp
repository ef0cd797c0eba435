// SPDX-License-Identifier: GPL-2.0-or-later
// The functions that flatdyn knows, and their derivation from a mechanism (recursive route).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graph/function.hpp"
#include "model/mechanism.hpp"
#include "symbolic/choices.hpp"

namespace flatdyn {

// One row per function: its name, one line of help, and how it is derived.
struct FunctionEntry {
  const char* name;
  const char* summary;
  const char* equation;
  Function (*derive)(const Mechanism&, const Choices&);
  // Other formulations of the same, where which one costs less depends on the robot; not every robot has them.
  std::vector<std::optional<Function> (*)(const Mechanism&, const Choices&)> alternatives = {};
  // Left out unless asked for by name: the regressors serve identification and adaptive control, and are larger than
  // all other functions of a controller together.
  bool on_request = false;
  bool has_choices = true;  // whether its cost depends on them
};

// In the order in which they are emitted: inverse_dynamics, inverse_dynamics_tip_force, inertia_matrix, christoffel,
// coriolis_matrix, gravity, bias, forward_dynamics, kinetic_energy, potential_energy, forward_kinematics, jacobian,
// jacobian_dot_qd; then on request inverse_dynamics_derivatives, forward_dynamics_derivatives, regressor,
// base_regressor, base_parameters, inverse_dynamics_base, adaptive_regressor.
const std::vector<FunctionEntry>& function_table();

// Throws Failure(usage) for the name of no function, and for no link of the robot.
void check_function_name(const Mechanism& mechanism, const std::string& name);

// 0: the column derive; k: the k-th alternative.
using Way = std::size_t;
inline constexpr Way kWays = 3;  // no function has more

// By name; also "forward_kinematics:LINK", "jacobian:LINK" and "jacobian_dot_qd:LINK" for any named link. nullopt if
// there is no such way to it. Throws as check_function_name does.
std::optional<Function> formulation(const Mechanism& mechanism, const std::string& name, Way way,
                                    const Choices& choices);

// Whether what it costs depends on choices.
bool has_choices(const Mechanism& mechanism, const std::string& name);

struct Formulation {
  Way way = 0;
  Choices choices;
  Function function;
};

// In every way that there is, each from its cheapest_choices().
std::vector<Formulation> formulations(const Mechanism& mechanism, const std::string& name);

// The first of them.
Function derive_function(const Mechanism& mechanism, const std::string& name);

}  // namespace flatdyn
