// SPDX-License-Identifier: GPL-2.0-or-later
// A function as it was derived and as the passes and a search left it.
#pragma once

#include <optional>
#include <vector>

#include "derivation/kernel/choices.hpp"
#include "graph/count.hpp"
#include "graph/function.hpp"
#include "graph/fusion.hpp"
#include "graph/passes/passes.hpp"

namespace flatdyn {

// The course of a search for the choices of a function.
struct SearchRecord {
  int candidates = 0;
  OperationCount before;
  bool is_closed_form = false;  // a closed form depends on no choices but the order of factoring
  Choices choices;
};

struct OptimisedFunction {
  Function function;
  Function derived;
  std::vector<PassRecord> passes;
  std::optional<SearchRecord> search;
};

// Several functions fused into one, made from one grouping of the parameters, so that they share as much as possible.
struct OptimisedFusion {
  Fusion fusion;
  Function derived;
  std::vector<PassRecord> passes;
};

std::vector<Function> functions_of(const std::vector<OptimisedFunction>& optimised);

}  // namespace flatdyn
