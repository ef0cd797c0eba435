// SPDX-License-Identifier: GPL-2.0-or-later
// A function by its name: checked, and derived in each way that there is.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graph/function.hpp"
#include "model/mechanism.hpp"
#include "symbolic/kernel/choices.hpp"

namespace flatdyn {

// Throws Failure(usage) for the name of no function, and for no link of the robot.
void check_function_name(const Mechanism& mechanism, const std::string& name);

// 0: the column derive of the table of functions; k: the k-th alternative.
using FormulationIndex = std::size_t;
inline constexpr FormulationIndex kFormulationCount = 3;  // no function has more

// By name; also "forward_kinematics:LINK", "jacobian:LINK" and "jacobian_dot_qd:LINK" for any named link. nullopt if
// there is no such way to it. Throws as check_function_name does.
std::optional<Function> formulation(const Mechanism& mechanism, const std::string& name, FormulationIndex way,
                                    const Choices& choices);

// Whether the function divides by pivots of B of which, for this robot, rounding may leave nothing.
bool may_lose_pivots(const Mechanism& mechanism, const std::string& name);

// Whether what it costs depends on choices.
bool has_choices(const Mechanism& mechanism, const std::string& name);

struct Formulation {
  FormulationIndex way = 0;
  Choices choices;
  Function function;
};

// In every way that there is, each from its cheapest_choices().
std::vector<Formulation> formulations(const Mechanism& mechanism, const std::string& name);

// In the first way, from one simple choice for all joints: right at once, and not the cheapest.
Function derive_function(const Mechanism& mechanism, const std::string& name);

}  // namespace flatdyn
