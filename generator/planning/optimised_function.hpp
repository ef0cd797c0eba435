// SPDX-License-Identifier: GPL-2.0-or-later
// A function as derived, and as the passes and a search left it.
#pragma once

#include <optional>
#include <vector>

#include "graph/count.hpp"
#include "graph/function.hpp"
#include "graph/fusion.hpp"
#include "passes/passes.hpp"
#include "symbolic/kernel/choices.hpp"

namespace flatdyn {

// How a search for the choices of a function went.
struct SearchRecord {
  int candidates = 0;
  OperationCount before;
  bool is_closed_form = false;  // which is made without choices, but for the order of factoring
  Choices choices;
};

struct OptimisedFunction {
  Function function;
  Function derived;
  std::vector<PassRecord> passes;
  std::optional<SearchRecord> search;
};

// Several functions as one, made from one grouping of the parameters, so that they share what they can.
struct OptimisedFusion {
  Fusion fusion;
  Function derived;
  std::vector<PassRecord> passes;
};

std::vector<Function> functions_of(const std::vector<OptimisedFunction>& optimised);

}  // namespace flatdyn
