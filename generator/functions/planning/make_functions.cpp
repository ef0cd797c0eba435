// SPDX-License-Identifier: GPL-2.0-or-later
#include "functions/planning/make_functions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <stdexcept>

#include "base/system/apart.hpp"
#include "derivation/dynamics/factorisation.hpp"
#include "functions/function_table.hpp"
#include "functions/planning/formulations.hpp"
#include "functions/planning/function_bytes.hpp"
#include "functions/planning/plan.hpp"
#include "functions/planning/plan_fusion.hpp"
#include "functions/planning/search.hpp"
#include "graph/mod_p.hpp"
#include "robot/input/common/context.hpp"
#include "truth/definition/pivot_ratio.hpp"

namespace flatdyn {
namespace {

// Checks a name. An error about a base that floats has the place of the base link.
void check_name(const LoadedRobot& model, const std::string& name) {
  try {
    check_function_name(model.mechanism, name);
  } catch (const Failure& failure) {
    if (!model.mechanism.floating_base || failure.kind() != FailureKind::unsupported) throw;
    Diagnostics found;
    found.unsupported(model.robot.links[static_cast<std::size_t>(model.robot.root)].place, failure.what(),
                      failure.hint());
    throw BadInput(FailureKind::unsupported, std::move(found));
  }
}

// Checks all names before the first function is derived.
void check_names(const LoadedRobot& model, const std::vector<std::string>& names) {
  for (auto name = names.begin(); name != names.end(); ++name) {
    check_name(model, *name);
    if (std::find(names.begin(), name, *name) != name) {
      throw Failure(FailureKind::usage, "function \"" + *name + "\" is asked for twice", "name it once");
    }
  }
}

// Replaces the functions by those from the best choices that a search finds for each.
void search_choices(const LoadedRobot& model, const SearchLimit& limit, std::vector<Plan>& plans,
                    Diagnostics& findings) {
  std::vector<ChoiceSearch> searches;
  for (const Plan& plan : plans) {
    const bool moves = !plan.is_closed_form && has_choices(effective_mechanism(model), plan.optimised.function.name);
    searches.emplace_back(effective_mechanism(model), plan.choices, plan.optimised.function, moves,
                          [&plan](const Choices& choices) { return plan.remake(choices).function; });
  }
  const int candidates = run_searches(searches, limit);
  for (std::size_t k = 0; k < plans.size(); ++k) {
    Plan& plan = plans[k];
    const OperationCount before = count_operations(plan.optimised.function);
    Plan found = plan;
    found.choices = searches[k].best();
    found.optimised = plan.remake(found.choices);
    if (!loses_digits(model, found)) plan = std::move(found);
    plan.optimised.search = SearchRecord{candidates, before, plan.is_closed_form, plan.choices};
  }
  if (!limit.seconds) return;
  findings.note({model.robot.file, 0}, fmt::format("the search has tried {} candidates per function", candidates),
                fmt::format("--search {} makes the same again", candidates));
}

// Notes that pivots are lost to rounding at some positions, where functions that divide by them return false.
void note_lost_pivots(const LoadedRobot& model, const std::vector<Plan>& plans, Diagnostics& findings) {
  constexpr double kLost = 0x1p-47;  // smallest pivot relative to its diagonal entry, in double
  const bool divides = std::any_of(plans.begin(), plans.end(),
                                   [](const Plan& plan) { return compares_pivots(plan.optimised.function); });
  if (!divides || smallest_pivot_ratio(effective_mechanism(model)) >= kLost) return;
  findings.note({model.robot.file, 0},
                "B(q) is singular to the last place of a double at some positions: what divides by its pivots, such as "
                "forward dynamics, returns false there",
                "give the links between its joints their inertia");
}

// Notes that steps are made for velocities, too, although the scene is at rest.
void note_steps_from_rest(const LoadedRobot& model, const std::vector<std::string>& names, Diagnostics& findings) {
  if (!model.robot.scene.at_rest) return;
  for (const std::string& name : names) {
    if (!find_row(name)->traits.leaves_rest) continue;
    findings.note({model.robot.file, 0},
                  name + " is made in full, although the scene holds still: a step may leave rest", "");
  }
}

// Refuses a function that divides by zero at every position: links may move inertia each, but not enough together.
void refuse_division_by_zero(const Function& function) {
  constexpr std::uint64_t kAttempts = 64;  // the square root of a random number is there at half of the points
  if (function.validity_conditions.empty()) return;
  for (std::uint64_t seed = 1; seed <= kAttempts; ++seed) {
    try {
      ModPArithmetic<kMersenne61> arithmetic(seed);
      evaluate(function, arithmetic);
      return;
    } catch (const std::domain_error&) {
      continue;
    }
  }
  throw Failure(FailureKind::unsupported, function.name + ": B(q) is singular at every position",
                "give the links between its joints their inertia");
}

// The error for a function that divides by B(q) although a link has too little inertia: the link and its place.
Diagnostics mending(const Robot& robot, const std::string& function, const SingularInertia& failure) {
  Diagnostics found;
  for (const Joint& joint : robot.joints) {
    if (joint.name != failure.joint) continue;
    const Link& link = robot.links[static_cast<std::size_t>(joint.child)];
    found.unsupported(
        link.place,
        fmt::format("{}: B(q) is singular, because joint \"{}\" ({}) moves no inertia: link \"{}\" has {}", function,
                    joint.name, relative_place_text(link.place, joint.place), link.name,
                    joint.type == JointType::prismatic ? "no mass" : "none about its axis"),
        "give the link its mass and inertia, or the joint an armature or a motor, or hold it still: --fix " +
            joint.name);
  }
  if (found.all().empty()) {  // the motion of a floating base
    const Link& base = robot.links[static_cast<std::size_t>(robot.root)];
    found.unsupported(
        base.place,
        fmt::format("{}: B(q) is singular, because the floating base, link \"{}\", has too little inertia", function,
                    base.name),
        "give the base its mass and inertia, or hold it still: --base fixed");
  }
  return found;
}

Plan checked_plan(const LoadedRobot& model, const std::string& name, Progress& progress) {
  Plan plan = planned(model, name, progress);
  refuse_division_by_zero(plan.optimised.function);
  return plan;
}

// The functions that other processes have made, by name; those that they could not make are missing. GiNaC is not made
// for threads. A search goes on from plans, which do not leave a process.
std::map<std::string, OptimisedFunction> made_apart(const LoadedRobot& model, const std::vector<std::string>& names,
                                                    const PipelineOptions& options, Progress& progress) {
  std::map<std::string, OptimisedFunction> made;
  const std::size_t processes = std::min(names.size(), processor_count());
  if (!options.in_processes || options.search || processes < 2) return made;
  progress.step(fmt::format("deriving {} functions", names.size()));
  const auto texts = computed_apart(names.size(), processes, [&](std::size_t k) {
    Progress quiet(true);
    return to_bytes(checked_plan(model, names[k], quiet).optimised);
  });
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (texts[k]) made.emplace(names[k], from_bytes(*texts[k]));
  }
  return made;
}

std::vector<std::string> names_of_functions(bool on_request, const Mechanism& mechanism) {
  std::vector<std::string> names;
  for (const FunctionRow& row : function_table()) {
    if (row.traits.on_request == on_request && row.applies_to(mechanism)) names.emplace_back(row.name);
  }
  return names;
}

// Checks the names that a scene gives; errors carry their places.
void check_scene_names(const LoadedRobot& model) {
  std::vector<Reference> functions = model.robot.scene.functions;
  Diagnostics found;
  for (auto function = functions.begin(); function != functions.end(); ++function) {
    const bool is_again = std::any_of(functions.begin(), function,
                                      [&](const Reference& before) { return before.name == function->name; });
    if (is_again) found.error(function->place, "functions: \"" + function->name + "\" is there twice", "name it once");
  }
  for (const SceneOutputs& outputs : model.robot.scene.outputs) functions.push_back(outputs.function);
  for (const Reference& function : functions) {
    try {
      check_function_name(model.mechanism, function.name);
    } catch (const Failure& failure) {
      found.error(function.place, failure.what(), failure.hint());
    }
  }
  refuse_errors(found);
}

}  // namespace

std::vector<Function> derive_numeric_functions(const LoadedRobot& model, const std::vector<std::string>& names,
                                               const std::string& what, Progress& progress) {
  require_numbers(model.robot, what);
  PipelineOptions options;
  options.functions = names;
  Diagnostics none;
  return functions_of(make_functions(without_scene_restrictions(model), options, progress, none));
}

std::vector<std::string> default_function_names(const Mechanism& mechanism) {
  return names_of_functions(false, mechanism);
}

std::vector<OptimisedFunction> make_functions(const LoadedRobot& model, const PipelineOptions& options,
                                              Progress& progress, Diagnostics& findings) {
  check_scene_names(model);
  const std::vector<std::string> wanted = functions_asked_for(options.functions, model.robot.scene);
  const bool asked = !wanted.empty();
  const std::vector<std::string> names = asked ? wanted : default_function_names(model.mechanism);
  check_names(model, names);
  std::vector<Plan> plans;
  std::map<std::string, OptimisedFunction> apart = made_apart(model, names, options, progress);
  for (const std::string& name : names) {
    try {
      const auto made = apart.find(name);
      plans.push_back(made != apart.end() ? Plan{std::move(made->second), {}, false, nullptr}
                                          : checked_plan(model, name, progress));
    } catch (const SingularInertia& failure) {
      Diagnostics found = mending(model.robot, name, failure);
      if (asked) throw BadInput(FailureKind::unsupported, std::move(found));
      for (const Diagnostic& each : found.all()) findings.warning(each.place, "left out " + each.message, each.hint);
    } catch (const Failure& failure) {
      if (asked || failure.kind() != FailureKind::unsupported) throw;
      findings.warning({model.robot.file, 0}, std::string("left out ") + failure.what(), failure.hint());
    }
  }
  note_lost_pivots(model, plans, findings);
  note_steps_from_rest(model, names, findings);
  if (options.warnings_are_errors && findings.has_warnings()) throw BadInput(FailureKind::input, findings);
  if (options.search) {
    progress.step("searching for better choices");
    search_choices(model, *options.search, plans, findings);
  }
  std::vector<OptimisedFunction> result;
  for (Plan& plan : plans) result.push_back(std::move(plan.optimised));
  return result;
}

OptimisedFusion make_fusion(const LoadedRobot& model, const std::vector<std::string>& functions, Progress& progress) {
  check_names(model, functions);
  return planned_fusion(model, functions, progress);
}

std::vector<Function> functions_of(const std::vector<OptimisedFunction>& optimised) {
  std::vector<Function> functions;
  for (const OptimisedFunction& each : optimised) functions.push_back(each.function);
  return functions;
}

}  // namespace flatdyn
