// SPDX-License-Identifier: GPL-2.0-or-later
// A function by its name: checked, and derived in each formulation that exists.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "derivation/kernel/choices.hpp"
#include "graph/function.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

// Throws Failure(usage) if no function has the name, or if it names a link that the robot does not have.
void check_function_name(const Mechanism& mechanism, const std::string& name);

// 0: the derivation of the function's row; k: its k-th alternative.
using FormulationIndex = std::size_t;
inline constexpr FormulationIndex kFormulationCount = 3;  // no function has more

// Derives a function by its name, also "forward_kinematics:LINK", "jacobian:LINK" and "jacobian_dot_qd:LINK" for any
// named link. nullopt if the formulation does not exist. Throws as check_function_name does.
std::optional<Function> formulation(const Mechanism& mechanism, const std::string& name, FormulationIndex way,
                                    const Choices& choices);

// The guard for functions of these names: if one divides by pivots of B, these are compared with their scales, unless
// the share of its scale that each keeps is proven to be too large for rounding to matter, in float, too.
PivotGuard pivot_guard(const Mechanism& mechanism, const std::vector<std::string>& names);

// Whether the function's cost depends on choices.
bool has_choices(const Mechanism& mechanism, const std::string& name);

struct Formulation {
  FormulationIndex way = 0;
  Choices choices;
  Function function;
};

// The function in every formulation that exists, each from its cheapest_choices().
std::vector<Formulation> formulations(const Mechanism& mechanism, const std::string& name);

// The function in the first formulation, from one simple choice for all joints: available at once, but not the
// cheapest.
Function derive_function(const Mechanism& mechanism, const std::string& name);

}  // namespace flatdyn
