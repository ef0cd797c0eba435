// SPDX-License-Identifier: GPL-2.0-or-later
// What a self test on the target compares with: states, among them the worst that a search finds, and what each
// function is there, from the recursive reference in 50 digits; with the errors that are allowed, and those that are
// proven.
#pragma once

#include <string>
#include <vector>

#include "diagnostics/progress.hpp"
#include "graph/function.hpp"
#include "model/mechanism.hpp"
#include "model/robot.hpp"
#include "model/states.hpp"

namespace flatdyn {

// Scaled errors (docs/accuracy.md) that a self test allows; angles of many turns count as often as they round.
inline constexpr double kAllowedUnits = 16;

// One entry of an output at one state: exact + rest is the value, to about 32 digits.
struct ExpectedEntry {
  double exact = 0, rest = 0;
  double allowed = 0;  // largest absolute error; negative: the entry is left out
  double proven = -1;  // bound of the absolute error, as `flatdyn certify` states it; negative: none is proven here
};

struct TestVectors {
  // In numbers of the scalar, all functions have values there: random ones within the limits, extremes, then the worst
  // one found of each function.
  std::vector<State> states;
  std::vector<std::vector<ExpectedEntry>> expected;  // by function: the entries of all outputs, state after state
};

// For the scalar "double" or "float". The same on every machine.
TestVectors test_vectors(const Robot& robot, const Mechanism& mechanism, const std::vector<Function>& functions,
                         const std::string& scalar, Progress& progress);

}  // namespace flatdyn
