// SPDX-License-Identifier: GPL-2.0-or-later
// What the stages cost as a whole: how they are made, and all functions in them beside all functions one by one.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/subject.hpp"
#include "diagnostics/progress.hpp"
#include "graph/count.hpp"
#include "load/loaded_robot.hpp"

namespace flatdyn {

// Of all functions of positions; nothing where there is none, or no variant is staged.
std::optional<Stages> bench_stages(const LoadedRobot& model, const std::vector<Function>& functions,
                                   const std::vector<BenchVariant>& variants, Progress& progress);

struct StageStep {
  std::string name;   // as the program names it: "stages/at"
  std::string title;  // in reports: "at(q)"
  OperationCount operations;
  std::string call;     // C++ statements, in double
  std::size_t entries;  // that these write, 1 at least
};

// Empty where there are no stages.
std::vector<StageStep> stage_steps(const BenchSubject& subject);

// Of the functions that are members of a stage.
std::vector<std::string> staged_names(const BenchSubject& subject);

}  // namespace flatdyn
