// SPDX-License-Identifier: GPL-2.0-or-later
// Where are rounding errors of generated code worst, and is it the code's fault? Random states, edge states and a
// search for the worst one, in float and double, in every variant; what is found worst is compared with 50 digits and
// with what the recursive reference loses there in the same precision.
#pragma once

#include <string>
#include <vector>

#include "diagnostics/progress.hpp"
#include "graph/function.hpp"
#include "model/mechanism.hpp"
#include "model/robot.hpp"
#include "model/states.hpp"
#include "reference/judge.hpp"

namespace flatdyn {

struct StressOptions {
  int states = 2000;       // random states
  int edges = 300;         // states of extremes
  int evaluations = 3000;  // of the search, per function and scalar
  unsigned seed = 1;
  double bound = 64;                  // largest scaled error allowed
  double ratio = 4;                   // to the reference's own
  std::vector<std::string> variants;  // names; empty: all
};

// A state where the error is large, against the reference at and around it.
struct StressFinding {
  std::string where;    // "random", "edge", "searched"
  std::string variant;  // the worst one
  State state;
  RoundingError error;   // in 50 digits
  double near = 0;       // scaled error of that variant, at the state or next to it: the largest
  double reference = 0;  // that of the reference, alike
  double ratio = 0;      // near over reference, which counts as one unit at least: less is luck
};

// One function in one scalar.
struct StressRow {
  std::string function, scalar;
  std::vector<InputKind> inputs;                         // that the function is given
  ErrorSummary random;                                   // scaled, at random states; of the worst variant at each
  double edge = 0;                                       // the largest at edge states
  StressFinding worst;                                   // the largest error
  StressFinding lost;                                    // the largest ratio
  std::size_t states = 0;                                // random ones
  std::size_t tried = 0, refused = 0;                    // with edges; the function does not hold there, or says so
  std::vector<std::pair<std::string, double>> variants;  // name, largest at random and edge states
  std::vector<RoundingError> points;                     // a sample of all states
  std::vector<std::size_t> histogram;                    // of scaled errors at random states, kStressBins
  bool passed = false;
};

// Bins of the histogram: two per power of two, from 2^-8 on; what is outside counts in the first or last.
inline constexpr int kStressBins = 40;
double stress_bin_start(int bin);

struct StressReport {
  std::string robot;
  StressOptions options;
  std::vector<std::string> symbols;  // free ones of the robot
  std::vector<StressRow> rows;
  std::vector<std::string> left_out;
  bool passed() const;
};

// Of all variants.
std::vector<std::string> stress_variant_names();

// Throws Failure(io) if there is no compiler, Failure(usage) for an unknown variant.
StressReport stress(const Robot& robot, const Mechanism& mechanism, const std::vector<Function>& functions,
                    const StressOptions& options, Progress& progress);

}  // namespace flatdyn
