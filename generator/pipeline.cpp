// SPDX-License-Identifier: GPL-2.0-or-later
#include "pipeline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "input/content_hash.hpp"
#include "passes/draft.hpp"
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
  OptimisedFunction result{{}, count_operations(derived), {}};
  result.function = run_passes(derived, &result.passes);
  return result;
}

// In the formulation, recursive or the closed form, that costs least once the passes are through with it.
OptimisedFunction make_function(const Mechanism& mechanism, const std::string& name, Progress& progress) {
  progress.step("deriving " + name);
  std::vector<Function> candidates = formulations(mechanism, name);
  std::optional<Function> closed = closed_variant(mechanism, candidates.front());
  if (closed) candidates.push_back(std::move(*closed));
  progress.step("optimising " + name);
  std::optional<OptimisedFunction> best;
  for (const Function& candidate : candidates) {
    OptimisedFunction made = optimised(candidate);
    if (!best || cost(made.function) < cost(best->function)) best = std::move(made);
  }
  return *best;
}

ExitCode code_of(const Diagnostics& errors) {
  if (errors.only_on_command_line()) return ExitCode::usage;
  return errors.only_unsupported() ? ExitCode::unsupported : ExitCode::input;
}

std::vector<std::string> names_of_functions(bool on_request) {
  std::vector<std::string> names;
  for (const FunctionEntry& entry : function_table()) {
    if (entry.on_request == on_request) names.emplace_back(entry.name);
  }
  return names;
}

}  // namespace

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
  return {std::move(*robot), std::move(mechanism), std::move(diagnostics), std::move(hash)};
}

std::vector<std::string> default_function_names() { return names_of_functions(false); }
std::vector<std::string> requested_function_names() { return names_of_functions(true); }

std::vector<OptimisedFunction> make_functions(const Model& model, const PipelineOptions& options, Progress& progress,
                                              Diagnostics& findings) {
  const bool asked = !options.functions.empty();
  const std::vector<std::string> names = asked ? options.functions : default_function_names();
  check_names(model.mechanism, names);
  std::vector<OptimisedFunction> result;
  for (const std::string& name : names) {
    try {
      result.push_back(make_function(model.mechanism, name, progress));
    } catch (const Failure& failure) {
      if (asked || failure.code() != ExitCode::unsupported) throw;
      findings.warning({model.robot.file, 0}, std::string("left out ") + failure.what(), failure.hint());
    }
  }
  if (options.warnings_are_errors && findings.has_warnings()) throw BadInput(ExitCode::input, findings);
  return result;
}

std::vector<Function> functions_of(const std::vector<OptimisedFunction>& optimised) {
  std::vector<Function> functions;
  for (const OptimisedFunction& each : optimised) functions.push_back(each.function);
  return functions;
}

}  // namespace flatdyn
