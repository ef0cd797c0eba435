// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "diagnostics/progress.hpp"
#include "pipeline.hpp"

namespace flatdyn {

// Functions of a robot to be run along a motion: in numbers, at any speed, with every entry, whatever a scene says of
// functions. Throws Failure(unsupported) for a robot with free symbols.
std::vector<Function> motion_functions(const Model& model, const std::vector<std::string>& names, Progress& progress);

// (Jᵀ h_e)_i, from a Jacobian of 6 rows, row by row; 0 without a force.
double tip_torque(std::span<const double> J, std::span<const double> h_e, std::size_t joint);

}  // namespace flatdyn
