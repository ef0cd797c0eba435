// SPDX-License-Identifier: GPL-2.0-or-later
// Several functions as one, from the grouping and the formulations from which all of them together cost least.
#pragma once

#include <string>
#include <vector>

#include "load/loaded_robot.hpp"
#include "planning/optimised_function.hpp"

namespace flatdyn {

// Throws BadInput where the scene asks of a function what it has not.
OptimisedFusion planned_together(const LoadedRobot& model, const std::vector<std::string>& functions,
                                 Progress& progress);

}  // namespace flatdyn
