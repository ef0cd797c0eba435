// SPDX-License-Identifier: GPL-2.0-or-later
// The data of a self test on the target: states, among them the worst that a search finds, and the functions' values
// there, from the recursive reference in 50 digits, with the allowed and the proven errors.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics/progress.hpp"
#include "code/emit/emit_options.hpp"
#include "graph/function.hpp"
#include "robot/model/mechanism.hpp"
#include "robot/model/robot.hpp"
#include "robot/model/states.hpp"

namespace flatdyn {

// The scaled error (docs/accuracy.md) that a self test allows, in units; rounding of angles of many turns is added.
inline constexpr double kAllowedUnits = 16;

// An entry of an output at one state: exact + rest is the value to about 32 digits.
struct ExpectedEntry {
  double exact = 0, rest = 0;
  double allowed = 0;  // largest allowed absolute error; negative: the entry is left out
  double proven = -1;  // bound of the absolute error by `flatdyn certify`; negative: none is proven here
};

struct TestVectors {
  // Numbers of the scalar, at which all functions have values: random states within the limits, extreme ones, then the
  // worst one found for each function.
  std::vector<State> states;
  // One list per function: the entries of all outputs, state after state
  std::vector<std::vector<ExpectedEntry>> expected;
};

// The vectors for the form's scalar, the same on every machine.
TestVectors test_vectors(const Robot& robot, const Mechanism& mechanism, const std::vector<Function>& functions,
                         const EmitOptions& form, Progress& progress);

}  // namespace flatdyn
