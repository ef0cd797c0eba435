// SPDX-License-Identifier: GPL-2.0-or-later
// How large the inputs of a function may be: the limits of the joints.
#pragma once

#include <functional>

#include "graph/graph.hpp"
#include "model/mechanism.hpp"

namespace flatdyn {

// Largest size of an input, in SI units.
using InputLimits = std::function<double(const Input&)>;

// Positions, speeds, accelerations and torques of the mechanism's joints. Throws Failure(unsupported) for an input that
// has no limit there: a limit that nobody gave, a free symbol, a tip force, a parameter.
InputLimits input_limits(const Mechanism& mechanism);

}  // namespace flatdyn
