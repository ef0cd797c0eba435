// SPDX-License-Identifier: GPL-2.0-or-later
#include "pipeline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "input/content_hash.hpp"
#include "passes/draft.hpp"
#include "scene/specialise.hpp"
#include "symbolic/closed_functions.hpp"

namespace flatdyn {
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

OptimisedFunction optimised(const Function& derived) {
  OptimisedFunction result{{}, derived, {}};
  result.function = run_passes(derived, &result.passes);
  return result;
}

ExitCode code_of(const Diagnostics& errors) {
  if (errors.only_on_command_line()) return ExitCode::usage;
  return errors.only_unsupported() ? ExitCode::unsupported : ExitCode::input;
}

void stop_at_errors(const Diagnostics& found) {
  if (found.has_errors()) throw BadInput(code_of(found), found);
}

// Without those that cost so much more than the cheapest that no pass makes up for it.
std::vector<Function> within_reach(std::vector<Function> candidates) {
  constexpr double kReach = 1.5;
  const auto operations = [](const Function& function) { return count_operations(function).arithmetic(); };
  int least = operations(candidates.front());
  for (const Function& candidate : candidates) least = std::min(least, operations(candidate));
  std::erase_if(candidates, [&](const Function& candidate) { return operations(candidate) > kReach * least; });
  return candidates;
}

// In the formulation, recursive or the closed form, that costs least once what the scene does not need is taken out and
// the passes are through with it.
OptimisedFunction make_function(const Model& model, const std::string& name, Progress& progress) {
  const Mechanism& mechanism = derived_from(model);
  Diagnostics found;
  progress.step("deriving " + name);
  std::vector<Function> candidates = within_reach(formulations(mechanism, name));
  std::optional<Function> closed = closed_variant(mechanism, candidates.front());
  if (closed) candidates.push_back(std::move(*closed));
  progress.step("optimising " + name);
  std::optional<OptimisedFunction> best;
  for (const Function& candidate : candidates) {
    const Function needed = specialised(candidate, mechanism, model.robot.scene, found);
    stop_at_errors(found);
    OptimisedFunction made = optimised(needed);
    if (!best || cost(made.function) < cost(best->function)) best = std::move(made);
  }
  return *best;
}

std::vector<std::string> names_of_functions(bool on_request) {
  std::vector<std::string> names;
  for (const FunctionEntry& entry : function_table()) {
    if (entry.on_request == on_request) names.emplace_back(entry.name);
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
  stop_at_errors(found);
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
  Mechanism mechanism = make_mechanism(*robot);
  std::string hash = file_hash(robot->files);
  std::optional<Abbreviation> abbreviation;
  const Scene& scene = robot->scene;
  if (scene.error_budget) abbreviation = abbreviated(mechanism, *scene.error_budget, scene.at_rest);
  return {std::move(*robot), std::move(mechanism), std::move(abbreviation), std::move(diagnostics), std::move(hash)};
}

std::vector<std::string> default_function_names() { return names_of_functions(false); }
std::vector<std::string> requested_function_names() { return names_of_functions(true); }

std::vector<OptimisedFunction> make_functions(const Model& model, const PipelineOptions& options, Progress& progress,
                                              Diagnostics& findings) {
  check_scene_names(model);
  const std::vector<std::string> wanted = functions_asked_for(options, model.robot.scene);
  const bool asked = !wanted.empty();
  const std::vector<std::string> names = asked ? wanted : default_function_names();
  check_names(model.mechanism, names);
  std::vector<OptimisedFunction> result;
  for (const std::string& name : names) {
    try {
      result.push_back(make_function(model, name, progress));
    } catch (const Failure& failure) {
      if (asked || failure.code() != ExitCode::unsupported) throw;
      findings.warning({model.robot.file, 0}, std::string("left out ") + failure.what(), failure.hint());
    }
  }
  if (options.warnings_are_errors && findings.has_warnings()) throw BadInput(ExitCode::input, findings);
  return result;
}

namespace {

// From one grouping, so that they share what they can. Of each function's formulations the one that makes the whole
// cheapest, one function after the other.
Fusion fused_from(const Model& model, const std::vector<std::string>& functions, const Grouping& grouping) {
  Diagnostics found;
  std::vector<std::vector<Function>> ways;
  std::vector<Function> chosen;
  for (const std::string& name : functions) {
    ways.push_back(formulations(derived_from(model), name, {&grouping, 1}));
    for (Function& way : ways.back()) way = specialised(way, model.mechanism, model.robot.scene, found);
    chosen.push_back(ways.back().front());
  }
  stop_at_errors(found);
  Fusion best = fused(chosen);
  for (std::size_t k = 0; k < functions.size(); ++k) {
    for (std::size_t other = 1; other < ways[k].size(); ++other) {
      std::vector<Function> changed = chosen;
      changed[k] = ways[k][other];
      Fusion candidate = fused(changed);
      if (cost(candidate.function) >= cost(best.function)) continue;
      best = std::move(candidate);
      chosen = std::move(changed);
    }
  }
  return best;
}

}  // namespace

OptimisedFusion make_fusion(const Model& model, const std::vector<std::string>& functions, Progress& progress) {
  check_names(model.mechanism, functions);
  progress.step("deriving functions together");
  std::optional<Fusion> best;
  for (const Grouping grouping : kGroupings) {
    Fusion candidate = fused_from(model, functions, grouping);
    if (!best || cost(candidate.function) < cost(best->function)) best = std::move(candidate);
  }
  progress.step("optimising functions together");
  OptimisedFusion result{std::move(*best), {}, {}};
  result.derived = result.fusion.function;
  result.fusion.function = run_passes(result.fusion.function, &result.passes);
  // Where there is little to share, each function in its own best form may cost less.
  std::vector<Function> apart, derived;
  for (const std::string& name : functions) {
    OptimisedFunction made = make_function(model, name, progress);
    apart.push_back(std::move(made.function));
    derived.push_back(std::move(made.derived));
  }
  Fusion side_by_side = fused(apart);
  if (cost(side_by_side.function) >= cost(result.fusion.function)) return result;
  return {std::move(side_by_side), fused(derived).function, {}};
}

std::vector<Function> functions_of(const std::vector<OptimisedFunction>& optimised) {
  std::vector<Function> functions;
  for (const OptimisedFunction& each : optimised) functions.push_back(each.function);
  return functions;
}

}  // namespace flatdyn
