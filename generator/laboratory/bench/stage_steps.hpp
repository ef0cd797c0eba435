// SPDX-License-Identifier: GPL-2.0-or-later
// The cost of the stages as a whole: making them, and all functions in them, compared with all functions one by one.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics/progress.hpp"
#include "functions/load/loaded_robot.hpp"
#include "graph/count.hpp"
#include "laboratory/bench/subject.hpp"

namespace flatdyn {

// The stages of all functions of positions; none if there is no such function, or no variant is staged.
std::optional<Stages> bench_stages(const LoadedRobot& model, const std::vector<Function>& functions,
                                   const std::vector<BenchVariant>& variants, Progress& progress);

struct StageStep {
  std::string name;   // name in the program: "stages/at"
  std::string title;  // title in reports: "at(q)"
  OperationCount operations;
  std::string call;     // C++ statements, in double
  std::size_t entries;  // entries that the call writes, at least 1
};

// The steps to time; empty if there are no stages.
std::vector<StageStep> stage_steps(const BenchSubject& subject);

// The names of the functions that are members of a stage.
std::vector<std::string> staged_names(const BenchSubject& subject);

}  // namespace flatdyn
