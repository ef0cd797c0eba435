// SPDX-License-Identifier: GPL-2.0-or-later
// Verification of generated functions in three ways: exactly (modulo primes, against the Lagrangian, which is compared
// with that of the robot as read); in 50 digits (the graph against the recursive Newton–Euler reference); in double
// (the compiled text against 50 digits, with the reference's own rounding error for comparison).
#pragma once

#include <nlohmann/json.hpp>

#include "base/diagnostics/progress.hpp"
#include "functions/deviation/expected.hpp"
#include "graph/function.hpp"
#include "robot/model/mechanism.hpp"
#include "robot/model/robot.hpp"
#include "truth/definition/as_read.hpp"

namespace flatdyn {

struct VerifyOptions {
  int states = 200;  // random states in double; edge states are added
  unsigned seed = 1;
  double bound = 16;  // largest scaled error allowed at random states
};

// Scaled errors: abs(x - exact) / (ε · magnitude), truth/reference/magnitude.hpp.
struct FunctionReport {
  std::string function;
  bool proven = false;      // equal to the Lagrangian at random points of prime fields
  double graph_error = 0;   // graph against reference, both in 50 digits, relative to the magnitude
  ErrorSummary generated;   // compiled text in double, random states
  ErrorSummary at_edges;    // the same at edge states, divided by 1 + the sum of all angles
  ErrorSummary reference;   // the reference itself in double
  std::size_t refused = 0;  // states where the code reports a pivot lost in rounding; they are not counted elsewhere
  bool passed = false;
};

struct Property {
  std::string name;
  std::string measured;
  bool passed = false;
};

struct VerifyReport {
  AsReadResult as_read;
  std::vector<FunctionReport> functions;
  std::vector<Property> properties;
  double failure_log2 = -1e9;  // log2 of the probability that a wrong function passes the exact comparison

  bool passed() const;
};

// Verifies functions of the mechanism. `robot`: the robot as written, for the reference.
VerifyReport verify(const Robot& robot, const Mechanism& mechanism, const std::vector<Function>& functions,
                    const VerifyOptions& options, Progress& progress);

std::string to_text(const VerifyReport& report);
nlohmann::ordered_json to_json(const VerifyReport& report);

}  // namespace flatdyn
