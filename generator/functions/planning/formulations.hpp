// SPDX-License-Identifier: GPL-2.0-or-later
// A function in each formulation that exists, from the choices that cost least.
#pragma once

#include <string>
#include <vector>

#include "functions/formulation.hpp"

namespace flatdyn {

// The guard for functions of these names: if one divides by pivots of B, these are compared with their scales, unless
// the share of its scale that each keeps is proven to be too large for rounding to matter, in float, too.
PivotGuard pivot_guard(const Mechanism& mechanism, const std::vector<std::string>& names);

struct Formulation {
  FormulationIndex way = 0;
  Choices choices;
  Function function;
};

// The function in every formulation that exists, each from its cheapest_choices().
std::vector<Formulation> formulations(const Mechanism& mechanism, const std::string& name);

}  // namespace flatdyn
