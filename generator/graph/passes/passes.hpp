// SPDX-License-Identifier: GPL-2.0-or-later
// The table of passes: each is a free function Function → Function that leaves every value unchanged (exactly) and
// never raises the operation count.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "graph/count.hpp"
#include "graph/function.hpp"

namespace flatdyn {

struct Pass {
  const char* name;
  const char* purpose;  // one line
  Function (*run)(const Function&);
};

// The passes in the order in which they are run.
const std::vector<Pass>& pass_table();

// The pass that is run once, after all of them, on functions with tanh.
const Pass& last_pass();

struct PassRecord {
  std::string pass;
  OperationCount before, after;
  int round = 1;       // of the table
  double seconds = 0;  // that the pass took
};

// Called with the record of a pass and the function that it has left.
using PassObserver = std::function<void(const PassRecord&, const Function&)>;

// Runs the whole table, repeatedly until the cost no longer falls enough (at most a few times), then the last pass.
Function run_passes(Function function, std::vector<PassRecord>* record = nullptr, const PassObserver& observer = {});

}  // namespace flatdyn
