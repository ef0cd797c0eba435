// SPDX-License-Identifier: GPL-2.0-or-later
#include "plan.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "graph/count.hpp"
#include "passes/draft.hpp"
#include "passes/reorder.hpp"
#include "scene/specialise.hpp"
#include "symbolic/closed_functions.hpp"
#include "symbolic/formulations.hpp"

namespace flatdyn {
namespace {

OptimisedFunction optimised(const Function& derived, unsigned order = 0) {
  OptimisedFunction result{{}, derived, {}, {}};
  result.function = run_passes(reordered(derived, order), &result.passes);
  return result;
}

// Without those that cost so much more than the cheapest that no pass makes up for it.
std::vector<Formulation> within_reach(std::vector<Formulation> candidates) {
  constexpr double kReach = 1.5;
  const auto operations = [](const Formulation& each) { return count_operations(each.function).arithmetic(); };
  int least = operations(candidates.front());
  for (const Formulation& candidate : candidates) least = std::min(least, operations(candidate));
  std::erase_if(candidates, [&](const Formulation& candidate) { return operations(candidate) > kReach * least; });
  return candidates;
}

OptimisedFunction as_needed(const Model& model, const Function& derived, unsigned order) {
  Diagnostics found;
  const Function needed = specialised(derived, derived_from(model), model.robot.scene, found);
  refuse_errors(found);
  return optimised(needed, order);
}

void keep_cheaper(Plan& plan, const Choices& choices) {
  OptimisedFunction made = plan.remake(choices);
  if (cost(made.function) >= cost(plan.made.function)) return;
  plan.made = std::move(made);
  plan.choices = choices;
}

// Formulations are compared by what they cost before the passes; after them, other frames and units may cost less.
void refine(const Mechanism& mechanism, Plan& plan) {
  constexpr int kLarge = 1500;  // operations: beyond, it takes long
  const Function& made = plan.made.function;
  if (!has_choices(mechanism, made.name) || count_operations(made).arithmetic() > kLarge) return;
  for (const Choices& other : with_other_still_frames(mechanism, plan.choices)) keep_cheaper(plan, other);
  for (const Choices& other : with_other_length_units(mechanism, plan.choices)) keep_cheaper(plan, other);
}

}  // namespace

// In the formulation, recursive or the closed form, that costs least once what the scene does not need is taken out and
// the passes are through with it.
Plan planned(const Model& model, const std::string& name, Progress& progress) {
  const Mechanism& mechanism = derived_from(model);
  progress.step("deriving " + name);
  const std::vector<Formulation> candidates = within_reach(formulations(mechanism, name));
  std::optional<Function> closed = closed_variant(mechanism, candidates.front().function);
  progress.step("optimising " + name);
  std::optional<Plan> best;
  for (const Formulation& candidate : candidates) {
    OptimisedFunction made = as_needed(model, candidate.function, 0);
    if (best && cost(made.function) >= cost(best->made.function)) continue;
    best = Plan{std::move(made), candidate.choices, false,
                [&model, &mechanism, name, way = candidate.way](const Choices& choices) {
                  return as_needed(model, *formulation(mechanism, name, way, choices), choices.order);
                }};
  }
  refine(mechanism, *best);
  if (!closed || !best->made.function.scales.empty()) return *best;
  OptimisedFunction made = as_needed(model, *closed, 0);
  if (cost(made.function) >= cost(best->made.function)) return *best;
  return {std::move(made), candidates.front().choices, true,
          [&model, closed](const Choices& choices) { return as_needed(model, *closed, choices.order); }};
}

}  // namespace flatdyn
