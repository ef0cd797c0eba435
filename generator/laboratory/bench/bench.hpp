// SPDX-License-Identifier: GPL-2.0-or-later
// Benchmark of time against error: every function of a robot in every variant, compared with peers.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics/progress.hpp"
#include "functions/deviation/expected.hpp"
#include "functions/load/loaded_robot.hpp"
#include "graph/count.hpp"
#include "laboratory/bench/statistics.hpp"

namespace flatdyn {

struct BenchOptions {
  double seconds = 10;  // timing per robot, s
  int states = 300;     // largest number of states at which errors are measured
  unsigned seed = 1;
  std::vector<std::string> variants;  // names of variants and peers; empty: all
};

// The names of all variants and of all possible peers.
std::vector<std::string> bench_variant_names();

struct BenchRow {
  std::string variant;  // name of the variant or the peer
  bool is_peer = false;
  bool is_whole = true;       // false if the call is given sines and cosines, or a stage, whose time is not included
  OperationCount operations;  // 0 for a peer
  Quartiles time;             // time of one call, ns; in a batch, of one state
  std::size_t rounds = 0;
  double ratio = 1;        // median time relative to that of the first variant
  ErrorSummary scaled;     // error in units of the last place of double, relative to the size of the terms
  ErrorSummary absolute;   // error of the worst entry, in the function's unit
  std::size_t states = 0;  // number of states at which errors were measured
  long bytes = 0;          // size of the code; 0 for a peer
  bool on_front = false;   // no row with a whole call is both faster and more accurate
};

struct BenchFunction {
  std::string name;
  std::string unit;  // "N m"
  OperationCount operations;
  int written_entries = 0;     // of its outputs
  int written_zeros = 0;       // those of them that are zero at every state
  std::vector<BenchRow> rows;  // fastest first
};

// A timing of the stages. "at(q)": making a stage; "all in stages": that and all functions as its members; "one by
// one": all functions without stages.
struct BenchStep {
  std::string name;
  OperationCount operations;
  Quartiles time;  // ns, in double
};

struct BenchStages {
  std::vector<std::string> functions;  // functions that are members of stages
  std::vector<BenchStep> steps;        // empty if there are no stages
};

struct BenchReport {
  std::string robot, compiler, flags;
  double seconds = 0;
  std::vector<BenchFunction> functions;
  BenchStages stages;
  std::vector<std::string> left_out;  // missing peers and variants, with the reason
};

// Runs the benchmark. Throws Failure(usage) for an unknown variant, Failure(bug) if a peer's numbers differ from the
// reference in 50 digits.
BenchReport bench(const LoadedRobot& model, const std::vector<Function>& functions, const BenchOptions& options,
                  Progress& progress);

}  // namespace flatdyn
