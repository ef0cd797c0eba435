// SPDX-License-Identifier: GPL-2.0-or-later
// Several functions as one, so that what they have in common is computed once.
#pragma once

#include <string>
#include <vector>

#include "graph/function.hpp"

namespace flatdyn {

// What a function was before it was fused: all but its graph.
struct FusedFunction {
  std::string name, summary, equation;
  std::vector<InputKind> inputs;
  bool at_rest = false;
  Task task{};
  std::size_t outputs = 0, conditions = 0, pivot_diagonals = 0;  // how many of these of the Function are its own
  int loop_conditions = 0;
};

struct Fusion {
  Function function;  // the outputs and conditions of all parts, one after the other
  std::vector<FusedFunction> parts;
};

// Named "a_b_c" after its parts; the inputs of all of them in order of kind.
Fusion fused(const std::vector<Function>& functions);

// Function k by itself, its graph that of the whole.
Function function_of(const Fusion& fusion, std::size_t k);

}  // namespace flatdyn
