// SPDX-License-Identifier: GPL-2.0-or-later
// The plan of one function: the formulation and the usual choices from which it costs least, and how to make it from
// other choices.
#pragma once

#include <functional>
#include <string>

#include "base/diagnostics/progress.hpp"
#include "functions/load/loaded_robot.hpp"
#include "functions/planning/optimised_function.hpp"

namespace flatdyn {

struct Plan {
  OptimisedFunction optimised;
  Choices choices;
  bool is_closed_form = false;
  std::function<OptimisedFunction(const Choices&)> remake;  // in the same formulation
};

// The plan of a function. Throws BadInput if the scene asks the function for something that it does not have. The model
// must outlive the plan.
Plan planned(const LoadedRobot& model, const std::string& name, Progress& progress);

// Whether the function as made loses many more digits to rounding than the recursive reference; a plan from planned()
// does not, where that is possible.
bool loses_digits(const LoadedRobot& model, const Plan& plan);

}  // namespace flatdyn
