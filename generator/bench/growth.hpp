// SPDX-License-Identifier: GPL-2.0-or-later
// How the cost of a function grows with the number of joints: on robots made for it, in general position.
#pragma once

#include <string>
#include <vector>

#include "bench/statistics.hpp"
#include "diagnostics/progress.hpp"
#include "graph/count.hpp"
#include "model/robot.hpp"

namespace flatdyn {

struct GrowthOptions {
  int joints = 32;      // of the largest robots; sizes are powers of two
  double seconds = 10;  // of all timing
  unsigned seed = 1;
  std::vector<std::string> functions = {"inverse_dynamics", "inertia_matrix"};
};

struct GrowthRow {
  int joints = 0;
  OperationCount operations;
  Quartiles time;           // of one call in double, ns
  double scaled_error = 0;  // the largest, at a few states
  double generation = 0;    // s, by this program
  double compilation = 0;   // s of processor time, by the compiler
  long peak_kilobytes = 0;  // of the compiler's memory
};

struct GrowthCurve {
  std::string shape, function;
  std::vector<GrowthRow> rows;                       // by number of joints
  int fitted_from = 0;                               // joints
  double operation_exponent = 0, time_exponent = 0;  // operations ~ joints^x, by least squares
};

struct GrowthReport {
  std::string compiler, flags;
  std::vector<GrowthCurve> curves;
};

GrowthReport bench_growth(const GrowthOptions& options, Progress& progress);

}  // namespace flatdyn
