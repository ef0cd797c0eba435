// SPDX-License-Identifier: GPL-2.0-or-later
// A function by its name: checked, and derived.
#pragma once

#include <optional>
#include <string>

#include "derivation/kernel/choices.hpp"
#include "functions/function_row.hpp"
#include "graph/function.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

// Throws Failure(usage) if no function has the name, or if it names a link that the robot does not have.
void check_function_name(const Mechanism& mechanism, const std::string& name);
// The row of the function; throws as check_function_name does.
const FunctionRow& checked_row(const Mechanism& mechanism, const std::string& name);

// 0: the derivation of the function's row; k: its k-th alternative. Derivatives have those of their function, behind
// those that use the structure of the dynamics.
using FormulationIndex = std::size_t;
inline constexpr FormulationIndex kFormulationCount = 4;  // no function has more

// Derives a function by its name, also "forward_kinematics:LINK", "jacobian:LINK" and "jacobian_dot_qd:LINK" for any
// named link, and its derivatives, such as "vjp:NAME". nullopt if the formulation does not exist.
// Throws as check_function_name does.
std::optional<Function> formulation(const Mechanism& mechanism, const std::string& name, FormulationIndex way,
                                    const Choices& choices);

// The text about a robot's coordinates: with a floating base or spherical joints, q̈ is a and q̇ is v.
std::string in_coordinates(const std::string& text, const Mechanism& mechanism);

// The function as far as it is differentiated: without kCondition.
Function without_condition(Function function);

// Whether the function's cost depends on choices.
bool has_choices(const Mechanism& mechanism, const std::string& name);

// One simple choice for all joints.
Choices plain_choices(const Mechanism& mechanism);

// The function in the first formulation, from plain_choices(): available at once, but not the cheapest.
Function derive_function(const Mechanism& mechanism, const std::string& name);

}  // namespace flatdyn
