// SPDX-License-Identifier: GPL-2.0-or-later
#include "pipeline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "input/context.hpp"
#include "model/pivot_share.hpp"
#include "model/snap_cancelled.hpp"
#include "plan.hpp"
#include "plan_together.hpp"
#include "search/search.hpp"
#include "symbolic/factorisation.hpp"
#include "symbolic/formulations.hpp"
#include "symbolic/functions.hpp"

namespace flatdyn {
namespace {

ExitCode code_of(const Diagnostics& errors) {
  if (errors.only_on_command_line()) return ExitCode::usage;
  return errors.only_unsupported() ? ExitCode::unsupported : ExitCode::input;
}

}  // namespace

void refuse_errors(const Diagnostics& found) {
  if (found.has_errors()) throw BadInput(code_of(found), found);
}

namespace {

// All of them before the first is derived.
void check_names(const Mechanism& mechanism, const std::vector<std::string>& names) {
  for (auto name = names.begin(); name != names.end(); ++name) {
    check_function_name(mechanism, *name);
    if (std::find(names.begin(), name, *name) != name) {
      throw Failure(ExitCode::usage, "function \"" + *name + "\" is asked for twice", "name it once");
    }
  }
}

// The same functions from the best choices that a search finds for each.
void search_choices(const Model& model, const SearchLimit& limit, std::vector<Plan>& plans, Diagnostics& findings) {
  std::vector<ChoiceSearch> searches;
  for (const Plan& plan : plans) {
    const bool moves = !plan.is_closed_form && has_choices(derived_from(model), plan.made.function.name);
    searches.emplace_back(derived_from(model), plan.choices, plan.made.function, moves,
                          [&plan](const Choices& choices) { return plan.remake(choices).function; });
  }
  const int candidates = run_searches(searches, limit);
  for (std::size_t k = 0; k < plans.size(); ++k) {
    Plan& plan = plans[k];
    const OperationCount before = count_operations(plan.made.function);
    Plan found = plan;
    found.choices = searches[k].best();
    found.made = plan.remake(found.choices);
    if (!loses_digits(model, found)) plan = std::move(found);
    plan.made.search = SearchRecord{candidates, before, plan.is_closed_form, plan.choices};
  }
  if (!limit.seconds) return;
  findings.note({model.robot.file, 0}, fmt::format("the search has tried {} candidates per function", candidates),
                fmt::format("--search {} makes the same again", candidates));
}

// Where rounding leaves nothing of a pivot, what divides by it can only say so.
void note_lost_pivots(const Model& model, const std::vector<Plan>& plans, Diagnostics& findings) {
  constexpr double kLost = 0x1p-47;  // of a double, where kLeastShare of it is lost
  const bool divides =
      std::any_of(plans.begin(), plans.end(), [](const Plan& plan) { return !plan.made.function.scales.empty(); });
  if (!divides || smallest_pivot_share(derived_from(model)) >= kLost) return;
  findings.note({model.robot.file, 0},
                "B(q) is singular to the last place of a double at some positions: what divides by its pivots, such as "
                "forward dynamics, returns false there",
                "give the links between its joints their inertia");
}

// Which link is to be mended before a function can divide by B(q), and where it stands.
Diagnostics mending(const Robot& robot, const std::string& function, const SingularInertia& failure) {
  Diagnostics found;
  for (const Joint& joint : robot.joints) {
    if (joint.name != failure.joint) continue;
    const Link& link = robot.links[static_cast<std::size_t>(joint.child)];
    found.unsupported(
        link.place,
        fmt::format("{}: B(q) is singular, because joint \"{}\" ({}) moves no inertia: link \"{}\" has {}", function,
                    joint.name, line_seen_from(link.place, joint.place), link.name,
                    joint.type == JointType::prismatic ? "no mass" : "none about its axis"),
        "give the link its mass and inertia, or the joint an armature or a motor, or hold it still: --fix " +
            joint.name);
  }
  return found;
}

std::vector<std::string> names_of_functions(bool on_request, const Mechanism& mechanism) {
  std::vector<std::string> names;
  for (const FunctionEntry& entry : function_table()) {
    if (entry.is_on_request() == on_request && entry.is_of(mechanism)) names.emplace_back(entry.name);
  }
  return names;
}

// Names that a scene gives, with their places.
void check_scene_names(const Model& model) {
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

// What the command line asks for, else the scene; empty if neither asks for anything.
std::vector<std::string> functions_asked_for(const PipelineOptions& options, const Scene& scene) {
  if (!options.functions.empty()) return options.functions;
  std::vector<std::string> names;
  for (const Reference& function : scene.functions) names.push_back(function.name);
  if (!names.empty()) return names;
  for (const SceneOutputs& outputs : scene.outputs) names.push_back(outputs.function.name);
  return names;
}

Needs needs_of(const PipelineOptions& options, const Scene& scene) {
  const std::vector<std::string> names = functions_asked_for(options, scene);
  const bool only_gravity = !names.empty() && std::all_of(names.begin(), names.end(), [](const std::string& name) {
    return name == "gravity" || name == "potential_energy";
  });
  return {scene.at_rest, only_gravity};
}

std::optional<Abbreviation> abbreviation_of(const Robot& robot, const Mechanism& mechanism,
                                            const PipelineOptions& options) {
  const Scene& scene = robot.scene;
  if (!scene.error_budget) return std::nullopt;
  try {
    return abbreviated(mechanism, *scene.error_budget, needs_of(options, scene));
  } catch (const Failure& failure) {
    throw Failure(failure.code(), robot.file + ": " + failure.what(), failure.hint());
  }
}

}  // namespace

const Mechanism& derived_from(const Model& model) {
  return model.abbreviation ? model.abbreviation->mechanism : model.mechanism;
}

Model read_model(const std::filesystem::path& path, const PipelineOptions& options) {
  Diagnostics diagnostics;
  std::optional<Robot> robot = read_robot(path, options.read, diagnostics);
  const bool refused_warnings = options.warnings_are_errors && diagnostics.has_warnings();
  if (!robot || refused_warnings) {
    const ExitCode code = code_of(diagnostics);
    throw BadInput(code, std::move(diagnostics));
  }
  Mechanism mechanism = snap_cancelled(dust_part(options.read), *robot);
  std::string hash = options.read.sources->hash(robot->files);
  std::optional<Abbreviation> abbreviation;
  if (!options.whole_functions) abbreviation = abbreviation_of(*robot, mechanism, options);
  return {std::move(*robot), std::move(mechanism), std::move(abbreviation), std::move(diagnostics), std::move(hash)};
}

void require_numbers(const Robot& robot, const std::string& what) {
  if (robot.symbols.empty()) return;
  throw Failure(ExitCode::unsupported,
                fmt::format("{}: the robot has free symbols ({}, ...): {} needs numbers", robot.file,
                            robot.symbols.front().name, what),
                "write numbers for its lengths and masses; rough masses and inertias do");
}

Model with_whole_functions(Model model) {
  Scene& scene = model.robot.scene;
  scene.at_rest = false;
  scene.functions.clear();
  scene.outputs.clear();
  scene.error_budget.reset();
  model.abbreviation.reset();
  return model;
}

std::vector<Function> whole_functions(const Model& model, const std::vector<std::string>& names,
                                      const std::string& what, Progress& progress) {
  require_numbers(model.robot, what);
  PipelineOptions options;
  options.functions = names;
  Diagnostics none;
  return functions_of(make_functions(with_whole_functions(model), options, progress, none));
}

void refuse_loops(const Model& model, const std::string& what) {
  if (!model.mechanism.has_loops()) return;
  throw Failure(ExitCode::unsupported, what + ": robots with closed loops are not supported yet",
                "inspect, generate, verify, stress, eval, simulate, torques, scale and identify know them; so do all "
                "commands where "
                "loops are parallelograms");
}

std::vector<std::string> default_function_names(const Mechanism& mechanism) {
  return names_of_functions(false, mechanism);
}

std::vector<OptimisedFunction> make_functions(const Model& model, const PipelineOptions& options, Progress& progress,
                                              Diagnostics& findings) {
  check_scene_names(model);
  const std::vector<std::string> wanted = functions_asked_for(options, model.robot.scene);
  const bool asked = !wanted.empty();
  const std::vector<std::string> names = asked ? wanted : default_function_names(model.mechanism);
  check_names(model.mechanism, names);
  std::vector<Plan> plans;
  for (const std::string& name : names) {
    try {
      plans.push_back(planned(model, name, progress));
    } catch (const SingularInertia& failure) {
      Diagnostics found = mending(model.robot, name, failure);
      if (asked) throw BadInput(ExitCode::unsupported, std::move(found));
      for (const Diagnostic& each : found.all()) findings.warning(each.place, "left out " + each.message, each.hint);
    } catch (const Failure& failure) {
      if (asked || failure.code() != ExitCode::unsupported) throw;
      findings.warning({model.robot.file, 0}, std::string("left out ") + failure.what(), failure.hint());
    }
  }
  note_lost_pivots(model, plans, findings);
  if (options.warnings_are_errors && findings.has_warnings()) throw BadInput(ExitCode::input, findings);
  if (options.search) {
    progress.step("searching for better choices");
    search_choices(model, *options.search, plans, findings);
  }
  std::vector<OptimisedFunction> result;
  for (Plan& plan : plans) result.push_back(std::move(plan.made));
  return result;
}

OptimisedFusion make_fusion(const Model& model, const std::vector<std::string>& functions, Progress& progress) {
  check_names(model.mechanism, functions);
  return planned_together(model, functions, progress);
}

std::vector<Function> functions_of(const std::vector<OptimisedFunction>& optimised) {
  std::vector<Function> functions;
  for (const OptimisedFunction& each : optimised) functions.push_back(each.function);
  return functions;
}

}  // namespace flatdyn
