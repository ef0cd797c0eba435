// SPDX-License-Identifier: GPL-2.0-or-later
#include "functions/planning/plan.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "functions/deviation/rounding_loss.hpp"
#include "functions/function_table.hpp"
#include "functions/load/bad_input.hpp"
#include "functions/planning/formulations.hpp"
#include "functions/scene/specialise.hpp"
#include "graph/count.hpp"
#include "graph/passes/draft.hpp"
#include "graph/passes/reorder.hpp"

namespace flatdyn {
namespace {

OptimisedFunction optimised(const Function& derived, unsigned order = 0) {
  OptimisedFunction result{{}, derived, {}, {}};
  result.function = run_passes(reordered(derived, order), &result.passes);
  return result;
}

// Removes formulations that cost so much more than the cheapest that no pass makes up for it.
std::vector<Formulation> within_reach(std::vector<Formulation> candidates) {
  constexpr double kReach = 1.5;
  const auto operations = [](const Formulation& each) { return count_operations(each.function).arithmetic(); };
  int least = operations(candidates.front());
  for (const Formulation& candidate : candidates) least = std::min(least, operations(candidate));
  std::erase_if(candidates, [&](const Formulation& candidate) { return operations(candidate) > kReach * least; });
  return candidates;
}

OptimisedFunction as_needed(const LoadedRobot& model, const Function& derived, unsigned order) {
  Diagnostics found;
  const Function needed = specialised(derived, effective_mechanism(model), model.robot.scene, found);
  refuse_errors(found);
  return optimised(needed, order);
}

// The largest loss of digits allowed, relative to the reference's, at the states tested; at the worst states found by a
// search, functions lose up to twice as much.
constexpr double kMostLoss = 2;

// Whether the function's loss of digits has to be checked. Functions that depend on the scene are not: there is no
// reference for them.
bool may_lose_digits(const LoadedRobot& model, const Plan& plan) {
  const Function& made = plan.optimised.function;
  return !plan.is_closed_form && !model.abbreviation && !model.mechanism.has_loops() && is_whole(made) &&
         !made.at_rest && has_choices(model.mechanism, made.name);
}

// Makes the function from choices, in one formulation.
std::function<OptimisedFunction(const Choices&)> maker(const LoadedRobot& model, const std::string& name,
                                                       FormulationIndex way, Progress& progress) {
  return [&model, name, way, &progress](const Choices& choices) {
    progress.step("deriving " + name);
    const Function derived = *formulation(effective_mechanism(model), name, way, choices);
    progress.step("optimising " + name);
    return as_needed(model, derived, choices.order);
  };
}

// Makes sure that the function does not lose digits. Masses that balance first moments may cost digits if they are far
// away or next to far lighter links. If they do, takes the cheapest formulation without such masses that loses none, or
// the one that loses least.
void avoid_digit_loss(const LoadedRobot& model, const std::string& name, Plan& plan, Progress& progress) {
  if (!may_lose_digits(model, plan)) return;
  RoundingCheck check(model.robot, model.mechanism);
  double least = check.loss(plan.optimised.function);
  if (least <= kMostLoss) return;
  const Choices cheapest = plan.choices;
  for (const Choices& choices : plain_variants(model.mechanism, cheapest)) {
    for (FormulationIndex way = 0; way < kFormulationCount; ++way) {
      const std::optional<Function> derived = formulation(effective_mechanism(model), name, way, choices);
      if (!derived) continue;
      Plan other{as_needed(model, *derived, choices.order), choices, false, maker(model, name, way, progress)};
      const double loss = check.loss(other.optimised.function);
      const bool is_fine = loss <= kMostLoss, was_fine = least <= kMostLoss;
      if (was_fine ? !is_fine || cost(other.optimised.function) >= cost(plan.optimised.function) : loss >= least)
        continue;
      plan = std::move(other);
      least = loss;
    }
  }
}

void keep_cheaper(Plan& plan, const Choices& choices) {
  OptimisedFunction made = plan.remake(choices);
  if (cost(made.function) >= cost(plan.optimised.function)) return;
  plan.optimised = std::move(made);
  plan.choices = choices;
}

// Refines the choices: formulations are compared by their cost before the passes, and after the passes other frames and
// units may cost less.
void refine(const Mechanism& mechanism, Plan& plan) {
  constexpr int kLarge = 1500;  // operations; for more it takes long
  const Function& made = plan.optimised.function;
  if (!has_choices(mechanism, made.name) || count_operations(made).arithmetic() > kLarge) return;
  for (const Choices& other : with_other_still_frames(mechanism, plan.choices)) keep_cheaper(plan, other);
  for (const Choices& other : with_other_length_units(mechanism, plan.choices)) keep_cheaper(plan, other);
}

// The plan from the cheapest choices, in the formulation (recursive or closed form) that costs least after
// specialisation to the scene and the passes.
Plan cheapest_plan(const LoadedRobot& model, const std::string& name, Progress& progress) {
  const Mechanism& mechanism = effective_mechanism(model);
  progress.step("deriving " + name);
  const std::vector<Formulation> candidates = within_reach(formulations(mechanism, name));
  std::optional<Function> closed = closed_variant(mechanism, candidates.front().function,
                                                  row_of(candidates.front().function).derivation.closed_form);
  progress.step("optimising " + name);
  std::optional<Plan> best;
  for (const Formulation& candidate : candidates) {
    OptimisedFunction made = as_needed(model, candidate.function, 0);
    if (best && cost(made.function) >= cost(best->optimised.function)) continue;
    best = Plan{std::move(made), candidate.choices, false, maker(model, name, candidate.way, progress)};
  }
  refine(mechanism, *best);
  if (!closed || compares_pivots(best->optimised.function)) return *best;
  OptimisedFunction made = as_needed(model, *closed, 0);
  if (cost(made.function) >= cost(best->optimised.function)) return *best;
  return {std::move(made), candidates.front().choices, true,
          [&model, closed](const Choices& choices) { return as_needed(model, *closed, choices.order); }};
}

}  // namespace

Plan planned(const LoadedRobot& model, const std::string& name, Progress& progress) {
  Plan plan = cheapest_plan(model, name, progress);
  avoid_digit_loss(model, name, plan, progress);
  return plan;
}

bool loses_digits(const LoadedRobot& model, const Plan& plan) {
  return may_lose_digits(model, plan) &&
         RoundingCheck(model.robot, model.mechanism).loss(plan.optimised.function) > kMostLoss;
}

}  // namespace flatdyn
