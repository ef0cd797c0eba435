// SPDX-License-Identifier: GPL-2.0-or-later
// Finds where rounding errors of generated code are worst, and whether the code or the problem causes them. It tries
// random states, extreme states and a search for the worst one, in float and double, in every variant; the worst are
// compared with 50 digits and with the errors of the recursive reference in the same precision.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics/progress.hpp"
#include "functions/deviation/rounding_error_meter.hpp"
#include "graph/function.hpp"
#include "robot/model/mechanism.hpp"
#include "robot/model/robot.hpp"
#include "robot/model/states.hpp"

namespace flatdyn {

struct StressOptions {
  int states = 2000;       // random states
  int edges = 300;         // states with extreme entries
  int evaluations = 3000;  // evaluations of the search, per function and scalar
  unsigned seed = 1;
  double bound = 64;                  // largest scaled error allowed
  double ratio = 4;                   // largest ratio to the reference's own error allowed
  std::vector<std::string> variants;  // names; empty: all
};

// A state with a large error, and the reference's error at and around it.
struct StressFinding {
  std::string where;    // "random", "edge", "searched"
  std::string variant;  // the worst variant
  State state;
  RoundingError error;   // measured with 50 digits
  double near = 0;       // largest scaled error of that variant at the state and its neighbours
  double reference = 0;  // the same of the reference
  double ratio = 0;      // near / reference, where reference counts as one unit at least: less is chance
};

// The results for one function in one scalar.
struct StressRow {
  std::string function, scalar;
  std::vector<InputKind> inputs;  // inputs that the function reads
  ErrorSummary random;            // scaled errors at random states; the worst variant at each
  double edge = 0;                // largest at extreme states
  StressFinding worst;            // the state with the largest error
  StressFinding lost;             // the state with the largest ratio
  std::size_t states = 0;         // number of random states
  // `tried` includes extreme states; `refused`: the function has no value there, or reports that
  std::size_t tried = 0, refused = 0;
  std::vector<std::pair<std::string, double>> variants;  // name, largest error at random and extreme states
  std::vector<RoundingError> points;                     // a sample of all states
  std::vector<std::size_t> histogram;                    // scaled errors at random states, kStressBins bins
  bool passed = false;
  std::vector<std::string> columns;  // names of a state's numbers in a file of states: of inputs but free symbols
};

// The bins of the histogram: two per power of two, from 2^-8 on; values outside count in the first or last bin.
inline constexpr int kStressBins = 40;
// The scaled error at which a bin begins.
double stress_bin_start(int bin);

struct StressReport {
  std::string robot;
  StressOptions options;
  std::vector<std::string> symbols;  // free symbols of the robot
  std::vector<StressRow> rows;
  std::vector<std::string> left_out;
  bool passed() const;
};

// The names of all variants.
std::vector<std::string> stress_variant_names();

// Runs the stress test. Throws Failure(io) if there is no compiler, Failure(usage) for an unknown variant.
StressReport stress(const Robot& robot, const Mechanism& mechanism, const std::vector<Function>& functions,
                    const StressOptions& options, Progress& progress);

}  // namespace flatdyn
