// SPDX-License-Identifier: GPL-2.0-or-later
// The functions of a loaded robot: derived, specialised to its scene, and optimised.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics/progress.hpp"
#include "functions/load/load_robot.hpp"
#include "functions/planning/limit.hpp"
#include "functions/planning/optimised_function.hpp"

namespace flatdyn {

struct PipelineOptions : LoadOptions {
  std::optional<SearchLimit> search;  // the search for each function's choices; none: the usual choices
  bool in_processes = false;          // whether several functions are made at a time, on as many processors
};

// Makes the functions that options.functions or the scene names, as the scene needs them; if neither names any, all
// that the robot allows, and those left out are warnings in `findings`. Throws BadInput if a function that was asked
// for is not possible, or for warnings if these count as errors.
std::vector<OptimisedFunction> make_functions(const LoadedRobot& model, const PipelineOptions& options,
                                              Progress& progress, Diagnostics& findings);

OptimisedFusion make_fusion(const LoadedRobot& model, const std::vector<std::string>& functions, Progress& progress);

// Derives functions for numeric evaluation, whatever the scene says of them. Throws Failure(unsupported) for a robot
// with free symbols; `what` names the task that needs their values.
std::vector<Function> derive_numeric_functions(const LoadedRobot& model, const std::vector<std::string>& names,
                                               const std::string& what, Progress& progress);

// The names of the functions of the table that are made if none are asked for, in its order.
std::vector<std::string> default_function_names(const Mechanism& mechanism);

}  // namespace flatdyn
