// SPDX-License-Identifier: GPL-2.0-or-later
// A robot's functions abbreviated by the error budgets that the benchmark compares (functions/scene/abbreviate.hpp).
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics/progress.hpp"
#include "functions/load/loaded_robot.hpp"
#include "laboratory/bench/subject.hpp"

namespace flatdyn {

struct Abbreviations {
  std::vector<AbbreviatedFunctions> made;  // one entry per budget that saves operations
  std::vector<std::string> left_out;       // a line each
};

// The abbreviations for all budgets of `variants`.
Abbreviations abbreviations(const LoadedRobot& model, const std::vector<Function>& functions,
                            const std::vector<BenchVariant>& variants, Progress& progress);

}  // namespace flatdyn
