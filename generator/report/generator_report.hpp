// SPDX-License-Identifier: GPL-2.0-or-later
// The cost of generation itself: processor time of each stage and function, and peak memory.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/diagnostics/progress.hpp"
#include "functions/planning/optimised_function.hpp"

namespace flatdyn {

struct GeneratorCost {
  std::string robot;
  std::vector<Progress::Step> steps;  // of one generation, from the start of the program
  std::vector<OptimisedFunction> functions;
};

// Two tables: each stage with its processor time and the program's peak memory at its end; and each function with the
// processor time of its derivations and of its passes, and the operations that are left.
std::string generator_text(const GeneratorCost& cost);
nlohmann::ordered_json generator_json(const GeneratorCost& cost);  // seconds, kilobytes

}  // namespace flatdyn
