// SPDX-License-Identifier: GPL-2.0-or-later
// The rows of steps in time, "step:METHOD", and of their derivatives by state and torque.
#pragma once

#include <vector>

#include "functions/function_row.hpp"

namespace flatdyn {

std::vector<FunctionRow> step_rows();

}  // namespace flatdyn
