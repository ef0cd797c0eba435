// SPDX-License-Identifier: GPL-2.0-or-later
#include "functions/planning/formulations.hpp"

#include <algorithm>
#include <utility>

#include "functions/function_row.hpp"
#include "graph/count.hpp"
#include "robot/model/inertia_bound.hpp"
#include "robot/model/rounded_up.hpp"

namespace flatdyn {

PivotGuard pivot_guard(const Mechanism& mechanism, const std::vector<std::string>& names) {
  // In float, a share of 2^-19 counts as lost, and rounding errors of pivots are below 2^-17.
  constexpr double kLeast = 0x1p-15;
  const bool divides = std::any_of(names.begin(), names.end(), [&](const std::string& name) {
    return checked_row(mechanism, name).traits.divides_by_pivots;
  });
  if (!divides) return {};
  const double share = scaled_inertia_bound(mechanism);
  if (share < kLeast) return {.compares = true, .diagonals = diagonal_bounds(mechanism)};
  return {.proven_share = rounded_down(share, 2)};
}

namespace {

std::optional<Formulation> cheapest_formulation(const Mechanism& mechanism, const std::string& name,
                                                FormulationIndex way, const PivotGuard& guard) {
  std::optional<Formulation> best;
  int fewest = 0;
  const auto consider = [&](Choices choices) {
    choices.guard = guard;
    std::optional<Function> made = formulation(mechanism, name, way, choices);
    if (!made) return 0;  // other choices yield none, either
    const int operations = count_operations(*made).arithmetic();
    if (!best || operations < fewest) {
      best = Formulation{way, choices, std::move(*made)};
      fewest = operations;
    }
    return operations;
  };
  if (has_choices(mechanism, name)) {
    cheapest_choices(mechanism, consider);
  } else {
    consider(plain_choices(mechanism));
  }
  return best;
}

}  // namespace

std::vector<Formulation> formulations(const Mechanism& mechanism, const std::string& name) {
  std::vector<Formulation> result;
  const PivotGuard guard = pivot_guard(mechanism, {name});
  for (FormulationIndex way = 0; way < kFormulationCount; ++way) {
    std::optional<Formulation> made = cheapest_formulation(mechanism, name, way, guard);
    if (made) result.push_back(std::move(*made));
  }
  return result;
}

}  // namespace flatdyn
