// SPDX-License-Identifier: GPL-2.0-or-later
// Run time against error: every function of a robot in every variant, beside peers.
#pragma once

#include <string>
#include <vector>

#include "bench/statistics.hpp"
#include "diagnostics/progress.hpp"
#include "graph/count.hpp"
#include "load/loaded_robot.hpp"
#include "reference/expected.hpp"

namespace flatdyn {

struct BenchOptions {
  double seconds = 10;  // of timing, per robot
  int states = 300;     // at which errors are measured, at most
  unsigned seed = 1;
  std::vector<std::string> variants;  // and peers, by name; empty: all
};

// Names of all variants and of all peers that there may be.
std::vector<std::string> bench_variant_names();

struct BenchRow {
  std::string variant;  // or the peer's name
  bool is_peer = false;
  bool is_whole = true;       // false where sines and cosines are given, or a stage: time without them
  OperationCount operations;  // of a peer 0
  Quartiles time;             // of one call, ns; in a batch, of one state
  std::size_t rounds = 0;
  double ratio = 1;        // of the median time to that of the first variant
  ErrorSummary scaled;     // in units of the last place of double, of the terms' size
  ErrorSummary absolute;   // in the function's unit, of the worst entry
  std::size_t states = 0;  // at which errors were measured
  long bytes = 0;          // of code; 0 for a peer
  bool on_front = false;   // nothing that is whole is both faster and more accurate
};

struct BenchFunction {
  std::string name;
  std::string unit;  // "N m"
  OperationCount operations;
  std::vector<BenchRow> rows;  // fastest first
};

// "at(q)": a stage is made; "all in stages": that, and all functions as their members; "one by one": without stages.
struct BenchStep {
  std::string name;
  OperationCount operations;
  Quartiles time;  // ns, in double
};

struct BenchStages {
  std::vector<std::string> functions;  // that the stages have
  std::vector<BenchStep> steps;        // none: there are no stages
};

struct BenchReport {
  std::string robot, compiler, flags;
  double seconds = 0;
  std::vector<BenchFunction> functions;
  BenchStages stages;
  std::vector<std::string> left_out;  // peers and variants that are not there, and why
};

// Throws Failure(usage) for an unknown variant, Failure(bug) if a peer's numbers are others than those of the reference
// in 50 digits.
BenchReport bench(const LoadedRobot& model, const std::vector<Function>& functions, const BenchOptions& options,
                  Progress& progress);

}  // namespace flatdyn
