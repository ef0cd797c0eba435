// SPDX-License-Identifier: GPL-2.0-or-later
// One function, from the formulation and the usual choices from which it costs least; and how it is made from others.
#pragma once

#include <functional>
#include <string>

#include "load/loaded_robot.hpp"
#include "planning/optimised_function.hpp"

namespace flatdyn {

struct Plan {
  OptimisedFunction optimised;
  Choices choices;
  bool is_closed_form = false;
  std::function<OptimisedFunction(const Choices&)> remake;  // of the same formulation
};

// Throws BadInput where the scene asks of the function what it has not. The model must outlive the plan.
Plan planned(const LoadedRobot& model, const std::string& name, Progress& progress);

// Whether the function as made loses much more to rounding than the recursive reference; a plan as above does not,
// where that can be had.
bool loses_digits(const LoadedRobot& model, const Plan& plan);

}  // namespace flatdyn
