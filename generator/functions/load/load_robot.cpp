// SPDX-License-Identifier: GPL-2.0-or-later
#include "functions/load/load_robot.hpp"

#include <algorithm>

#include "functions/function_table.hpp"
#include "robot/input/reader.hpp"
#include "robot/model/snap_cancelled.hpp"

namespace flatdyn {
namespace {

TorqueScope torque_scope_of(const LoadOptions& options, const Scene& scene) {
  const std::vector<std::string> names = functions_asked_for(options.functions, scene);
  const bool only_gravity = !names.empty() && std::all_of(names.begin(), names.end(), [](const std::string& name) {
    const FunctionRow* row = find_row(name);
    return row != nullptr && row->traits.depends_on_gravity_only;
  });
  return {scene.at_rest, only_gravity};
}

std::optional<Abbreviation> abbreviation_of(const Robot& robot, const Mechanism& mechanism,
                                            const LoadOptions& options) {
  const Scene& scene = robot.scene;
  if (!scene.error_budget) return std::nullopt;
  try {
    return abbreviated(mechanism, *scene.error_budget, torque_scope_of(options, scene));
  } catch (const Failure& failure) {
    throw Failure(failure.kind(), robot.file + ": " + failure.what(), failure.hint());
  }
}

}  // namespace

std::vector<std::string> functions_asked_for(const std::vector<std::string>& on_command_line, const Scene& scene) {
  if (!on_command_line.empty()) return on_command_line;
  std::vector<std::string> names;
  for (const Reference& function : scene.functions) names.push_back(function.name);
  if (!names.empty()) return names;
  for (const SceneOutputs& outputs : scene.outputs) names.push_back(outputs.function.name);
  return names;
}

LoadedRobot load_robot(const std::filesystem::path& path, const LoadOptions& options) {
  Diagnostics diagnostics;
  std::optional<Robot> robot = read_robot(path, options.read, diagnostics);
  const bool refused_warnings = options.warnings_are_errors && diagnostics.has_warnings();
  if (!robot || refused_warnings) {
    const FailureKind kind = kind_of(diagnostics);
    throw BadInput(kind, std::move(diagnostics));
  }
  Mechanism mechanism = snap_cancelled(dust_part(options.read), *robot);
  std::string hash = options.read.sources->hash(robot->files);
  std::optional<Abbreviation> abbreviation;
  if (!options.skip_error_budget) abbreviation = abbreviation_of(*robot, mechanism, options);
  return {std::move(*robot), std::move(mechanism), std::move(abbreviation), std::move(diagnostics), std::move(hash)};
}

}  // namespace flatdyn
