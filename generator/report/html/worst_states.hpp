// SPDX-License-Identifier: GPL-2.0-or-later
// The worst states of a robot, found and saved by `flatdyn stress`, as rows of a table.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics/diagnostics.hpp"

namespace flatdyn {

struct WorstState {
  std::string function, scalar;
  std::string found;                               // "random", "edge", "searched"
  std::string variant;                             // the worst variant there
  std::string error, condition, reference, ratio;  // with two digits, or "∞"
  std::string state;                               // as CSV for `flatdyn eval`
  bool passed = true;
};

struct WorstStates {
  std::string bound, ratio;  // the limits of `stress`
  std::vector<WorstState> rows;
};

// Reads stress.json of `flatdyn stress ROBOT -o FOLDER`. A file of another kind or of another robot is an error in
// `diagnostics`. Throws Failure(io) if the file cannot be read.
WorstStates read_worst_states(const std::string& file, const std::string& robot, Diagnostics& diagnostics);

}  // namespace flatdyn
