// SPDX-License-Identifier: GPL-2.0-or-later
// Rules written once, as generic functions of a point: [](auto& point, const Output& output) { return values; }.
#pragma once

#include "truth/definition/definition.hpp"
#include "truth/definition/definition_point.hpp"

namespace flatdyn {

// The rule over the three fields. `Generic`: the type of a function object without state.
template <class Generic>
constexpr Rules rules(Generic) {
  return {
      [](DefinitionPoint<ModPArithmetic<kMersenne61>>& at, const Output& output) { return Generic{}(at, output); },
      [](DefinitionPoint<ModPArithmetic<kPrime61b>>& at, const Output& output) { return Generic{}(at, output); },
      [](DefinitionPoint<ModPArithmetic<kPrime61c>>& at, const Output& output) { return Generic{}(at, output); },
  };
}

// The function's own values as they are.
inline constexpr Rules kOwnValues = rules([](auto& point, const Output& output) { return point.own(output); });

// The definition of outputs that are compared as they are.
template <class Generic>
constexpr Definition defined_as(Generic expected) {
  return {rules(expected), kOwnValues, [](const Mechanism&, const Function&) { return 1.0; }};
}

}  // namespace flatdyn
