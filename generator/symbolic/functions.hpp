// SPDX-License-Identifier: GPL-2.0-or-later
// The functions that flatdyn knows, and their derivation from a mechanism (recursive formulations).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graph/function.hpp"
#include "model/mechanism.hpp"
#include "symbolic/kernel/choices.hpp"

namespace flatdyn {

enum class FunctionKind {
  dynamics,     // uses inertial parameters as numbers
  kinematics,   // uses no inertial parameters
  loops,        // kinematics of robots with closed loops
  derivatives,  // derivatives of dynamics
  operational,  // operational-space dynamics
  regressor,    // has the parameters as factors or inputs, and chooses its own
};

// One row per function: its name, one line of help, and how it is derived.
struct FunctionEntry {
  const char* name;
  const char* summary;
  const char* equation;
  FunctionKind kind;
  Function (*derive)(const Mechanism&, const Choices&);
  // Other formulations of the same function; which one costs least depends on the robot, and not every robot has them.
  std::vector<std::optional<Function> (*)(const Mechanism&, const Choices&)> alternatives = {};

  // Whether the function is left out unless asked for by name. These functions serve identification, adaptive control,
  // optimisers and operational-space control, and are larger than all other functions of a controller together.
  bool is_on_request() const {
    return kind != FunctionKind::dynamics && kind != FunctionKind::kinematics && kind != FunctionKind::loops;
  }
  // Whether the function is computed by B = Lᵀ D L, or by articulated bodies.
  bool divides_by_pivots() const {
    return kind == FunctionKind::operational || std::string(name).rfind("forward_dynamics", 0) == 0;
  }
  // Whether the function applies to the robot: those of loops require closed loops.
  bool is_of(const Mechanism& mechanism) const { return kind != FunctionKind::loops || mechanism.has_loops(); }
};

// The table, in the order in which functions are emitted: inverse_dynamics, inverse_dynamics_tip_force, inertia_matrix,
// christoffel, coriolis_matrix, gravity, bias, forward_dynamics, kinetic_energy, potential_energy, forward_kinematics,
// jacobian, jacobian_dot_qd; for robots with closed loops loop_closure, loop_jacobian, loop_step, loop_motion; then on
// request inverse_dynamics_derivatives, forward_dynamics_derivatives, operational_inertia, operational_bias,
// null_space_torque, regressor, base_regressor, base_parameters, inverse_dynamics_base, adaptive_regressor.
const std::vector<FunctionEntry>& function_table();

using LinkDerivation = Function (*)(const Mechanism&, const LinkFrame&);

// The derivation of the function of this name for a link other than the tip; null for functions that do not belong to a
// link.
LinkDerivation link_derivation(const std::string& name);

}  // namespace flatdyn
