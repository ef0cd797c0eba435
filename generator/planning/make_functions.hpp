// SPDX-License-Identifier: GPL-2.0-or-later
// Functions of a loaded robot: derived, specialised to its scene, and optimised.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "diagnostics/progress.hpp"
#include "load/load_robot.hpp"
#include "planning/limit.hpp"
#include "planning/optimised_function.hpp"

namespace flatdyn {

struct PipelineOptions : LoadOptions {
  std::optional<SearchLimit> search;  // for the choices that each function is derived from; none: the usual ones
};

// The functions that options.functions or the scene names, made as the scene needs them; or all that the robot allows:
// those that are left out are warnings in `findings`.
std::vector<OptimisedFunction> make_functions(const LoadedRobot& model, const PipelineOptions& options,
                                              Progress& progress, Diagnostics& findings);

OptimisedFusion make_fusion(const LoadedRobot& model, const std::vector<std::string>& functions, Progress& progress);

// Functions to be run in numbers, whatever the scene says of them. Throws Failure(unsupported) for a robot with free
// symbols; `what` needs their values.
std::vector<Function> derive_numeric_functions(const LoadedRobot& model, const std::vector<std::string>& names,
                                               const std::string& what, Progress& progress);

// Names of the functions of the table that are made unless others are asked for, in its order.
std::vector<std::string> default_function_names(const Mechanism& mechanism);

}  // namespace flatdyn
