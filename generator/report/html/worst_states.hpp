// SPDX-License-Identifier: GPL-2.0-or-later
// The worst states of a robot, as `flatdyn stress` has found and saved them: rows of a table.
#pragma once

#include <string>
#include <vector>

#include "diagnostics/diagnostics.hpp"

namespace flatdyn {

struct WorstState {
  std::string function, scalar;
  std::string found;                               // "random", "edge", "searched"
  std::string variant;                             // the one that is worst there
  std::string error, condition, reference, ratio;  // of two digits; "∞"
  std::string state;                               // CSV, for `flatdyn eval`
  bool passed = true;
};

struct WorstStates {
  std::string bound, ratio;  // what `stress` allowed
  std::vector<WorstState> rows;
};

// From stress.json of `flatdyn stress ROBOT -o FOLDER`. What is no such file, or is of another robot, is an error in
// `diagnostics`. Throws Failure(io) where the file cannot be read.
WorstStates read_worst_states(const std::string& file, const std::string& robot, Diagnostics& diagnostics);

}  // namespace flatdyn
