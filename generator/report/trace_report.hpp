// SPDX-License-Identifier: GPL-2.0-or-later
// Time and operations of each stage and pass.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics/progress.hpp"
#include "functions/planning/optimised_function.hpp"

namespace flatdyn {

// Two tables: the steps with their seconds; and the passes of each function with operations before and after, and
// milliseconds. Deriving a function includes all of its formulations, which are optimised in the step after it.
std::string describe_trace(const std::vector<Progress::Step>& steps, const std::vector<OptimisedFunction>& functions);

}  // namespace flatdyn
