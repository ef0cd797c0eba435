// SPDX-License-Identifier: GPL-2.0-or-later
// Fusion of several functions into one, so that their common subexpressions are computed once.
#pragma once

#include <string>
#include <vector>

#include "graph/function.hpp"

namespace flatdyn {

// A function as it was before fusion, without its graph.
struct FusedFunction {
  std::string name, summary, equation;
  std::vector<InputKind> inputs;
  bool at_rest = false;
  Task task{};
  // The numbers of its own outputs, conditions and pivot scales in the fused function.
  std::size_t outputs = 0, conditions = 0, pivot_scales = 0;
  double proven_pivot_share = 0;
  int loop_conditions = 0;
  std::string inverted;
};

struct Fusion {
  Function function;  // the outputs and conditions of all parts, one part after the other
  std::vector<FusedFunction> parts;
};

// Fuses functions. The result is named "a_b_c" after its parts; its inputs are those of all parts, ordered by kind.
Fusion fused(const std::vector<Function>& functions);

// Part k of a fusion as a function of its own, over the graph of the whole.
Function function_of(const Fusion& fusion, std::size_t k);

}  // namespace flatdyn
