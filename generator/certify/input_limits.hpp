// SPDX-License-Identifier: GPL-2.0-or-later
// The largest sizes of a function's inputs: the limits of the joints.
#pragma once

#include <functional>

#include "graph/graph.hpp"
#include "model/mechanism.hpp"

namespace flatdyn {

// The largest size of an input, in SI units.
using InputLimits = std::function<double(const Input&)>;

// The limits of positions, speeds, accelerations and torques of the mechanism's joints. Throws Failure(unsupported) for
// an input without a limit: a limit that nobody gave, a free symbol, a tip force, a parameter.
InputLimits input_limits(const Mechanism& mechanism);

}  // namespace flatdyn
