// SPDX-License-Identifier: GPL-2.0-or-later
// Several functions as one, from the grouping and the formulations that make all of them together cheapest.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics/progress.hpp"
#include "functions/load/loaded_robot.hpp"
#include "functions/planning/optimised_function.hpp"

namespace flatdyn {

// Throws BadInput if the scene asks a function for something that it does not have.
OptimisedFusion planned_fusion(const LoadedRobot& model, const std::vector<std::string>& functions, Progress& progress);

}  // namespace flatdyn
