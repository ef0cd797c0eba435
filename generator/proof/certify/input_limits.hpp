// SPDX-License-Identifier: GPL-2.0-or-later
// The largest sizes of a function's inputs: the limits of the joints, and of a floating base.
#pragma once

#include <functional>
#include <string>

#include "graph/graph.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

// The largest size of an input, in SI units.
using InputLimits = std::function<double(const Input&)>;

// The limits of positions, speeds, accelerations and torques of the mechanism's joints, as numbers of `scalar`,
// "double" or "float": a limit that the scalar rounds up may be an input. The limits of a floating base are those of
// each component of its motion; each component of gravity in its axes may be as large as gravity. Throws
// Failure(unsupported) for an input without a limit: a limit that nobody gave, a free symbol, a tip force, a parameter.
InputLimits input_limits(const Mechanism& mechanism, const std::string& scalar = "double");

}  // namespace flatdyn
