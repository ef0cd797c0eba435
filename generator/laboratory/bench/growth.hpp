// SPDX-License-Identifier: GPL-2.0-or-later
// Growth of a function's cost with the number of joints, on generated robots in general position.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics/progress.hpp"
#include "graph/count.hpp"
#include "laboratory/bench/statistics.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

struct GrowthOptions {
  int joints = 32;      // joints of the largest robots; sizes are powers of two
  double seconds = 10;  // total timing, s
  unsigned seed = 1;
  std::vector<std::string> functions = {"inverse_dynamics", "inertia_matrix"};
};

struct GrowthRow {
  int joints = 0;
  OperationCount operations;
  Quartiles time;           // time of one call in double, ns
  double scaled_error = 0;  // largest error at a few states
  double generation = 0;    // time of generation by this program, s
  double compilation = 0;   // processor time of the compiler, s
  long peak_kilobytes = 0;  // peak memory of the compiler
};

// One function on robots of one shape.
struct GrowthCurve {
  std::string shape, function;
  std::vector<GrowthRow> rows;                       // by number of joints
  int fitted_from = 0;                               // joints of the smallest robot in the fit
  double operation_exponent = 0, time_exponent = 0;  // operations ~ joints^x, by least squares
};

struct GrowthReport {
  std::string compiler, flags;
  std::vector<GrowthCurve> curves;
};

// Generates, compiles and times the robots. Throws Failure(bug) if a result is wrong, Failure(io) if there is no
// compiler.
GrowthReport bench_growth(const GrowthOptions& options, Progress& progress);

}  // namespace flatdyn
