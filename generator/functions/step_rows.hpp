// SPDX-License-Identifier: GPL-2.0-or-later
// The rows of steps in time, "step:METHOD", and of their derivatives by state and torque.
#pragma once

#include <vector>

#include "functions/function_row.hpp"

namespace flatdyn {

// The rows of a table with these behind those of forward dynamics and its derivatives.
std::vector<FunctionRow> with_steps(std::vector<FunctionRow> rows);

}  // namespace flatdyn
