// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/stress/one_robot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <random>

#include "base/system/process.hpp"
#include "code/languages/emit.hpp"
#include "code/languages/readers.hpp"
#include "code/readback/emitted_text.hpp"
#include "code/readback/straight_line_values.hpp"
#include "functions/function_table.hpp"
#include "functions/load/load_robot.hpp"
#include "functions/planning/formulations.hpp"
#include "functions/planning/make_functions.hpp"
#include "graph/passes/passes.hpp"

namespace flatdyn {
namespace {

LoadedRobot model_of(const PlainRobot& robot, const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / "robot.toml";
  write_file(path, robot_file(robot));
  return load_robot(path, {});
}

// The function as `generate` makes it.
Function usual(const LoadedRobot& model, const std::string& name) {
  PipelineOptions options;
  options.functions = {name};
  Progress quiet(true);
  Diagnostics findings;
  return functions_of(make_functions(model, options, quiet, findings)).front();
}

Choices drawn_choices(const Mechanism& mechanism, std::mt19937& engine) {
  Choices choices = uniform_choices(mechanism, kGroupings[engine() % std::size(kGroupings)]);
  const std::vector<Choices> others = with_other_still_frames(mechanism, choices);
  const std::size_t which = engine() % (others.size() + 1);
  if (which < others.size()) choices = others[which];
  for (JointChoice& joint : choices.joints) {
    joint.grouping.balance = kBalances[engine() % std::size(kBalances)];
    joint.grouping.grouping = kGroupings[engine() % std::size(kGroupings)];
  }
  return choices;
}

// The function in a random formulation out of those that a search tries; for robots of one or two joints, one in four
// in closed form. A quarter of them go through the passes, which take most of the time.
Function drawn(const LoadedRobot& model, const std::string& name, std::mt19937& engine) {
  const Mechanism& mechanism = model.mechanism;
  const Choices choices = drawn_choices(mechanism, engine);
  std::optional<Function> derived = formulation(mechanism, name, engine() % kFormulationCount, choices);
  if (!derived) derived = formulation(mechanism, name, 0, choices);
  if (mechanism.size() <= 2 && engine() % 4 == 0) {
    if (std::optional<Function> closed = closed_variant(mechanism, *derived, row_of(*derived).derivation.closed_form))
      derived = std::move(closed);
  }
  return engine() % 4 == 0 ? run_passes(*derived) : *derived;
}

}  // namespace

OneRobot::OneRobot(const PlainRobot& robot, unsigned seed, bool is_usual, const RandomRobotsOptions& options,
                   const std::filesystem::path& folder)
    : model_(model_of(robot, folder)),
      name_space_(robot.name),
      states_(random_states(model_.mechanism, options.states, seed)),
      reference_(std::make_unique<ExpectedValues>(model_.robot, model_.mechanism, seed)) {
  std::mt19937 engine(seed);
  for (const std::string& name : options.functions) {
    try {
      Function function = is_usual ? usual(model_, name) : drawn(model_, name, engine);
      functions_.push_back(options.corrupt ? options.corrupt(function) : std::move(function));
    } catch (const Failure& failure) {
      if (failure.kind() != FailureKind::unsupported) throw;
    }
  }
  EmitOptions emit;
  emit.name_space = name_space_;
  header_ = emit_header(model_.mechanism, functions_, emit);
  const EmittedText text(header_, header_reader());
  for (std::size_t k = 0; k < functions_.size(); ++k) {
    lines_.push_back(text.operations(k, functions_[k]));
    expected_.push_back(reference_->of(functions_[k]));
  }
}

std::vector<double> OneRobot::executed(std::size_t k, const State& state) const { return outputs_of(lines_[k], state); }

double OneRobot::error(std::size_t k, const State& state, const std::vector<double>& values) const {
  return scaled_error(values, expected_[k].exact(state), expected_[k].scale(state));
}

std::optional<RandomRobotFault> fault_of(const OneRobot& robot, std::size_t function, const State& state,
                                         const std::vector<double>& values, RandomRobotFault::How how,
                                         const RandomRobotsOptions& options, RandomRobotsReport& report) {
  const std::string& name = robot.functions()[function].name;
  const double error = robot.error(function, state, values);
  const auto place = std::find(options.functions.begin(), options.functions.end(), name) - options.functions.begin();
  double& worst = report.worst[static_cast<std::size_t>(place)];
  worst = std::max(worst, error);
  if (error <= options.bound) return std::nullopt;
  return RandomRobotFault{how, name, error};
}

std::optional<RandomRobotFault> fault_of(const OneRobot& robot, const RandomRobotsOptions& options,
                                         RandomRobotsReport& report) {
  for (const State& state : robot.states()) {
    RandomRobotValues all{robot.model(), robot.functions(), state, {}};
    for (std::size_t k = 0; k < robot.functions().size(); ++k) {
      all.values.push_back(robot.executed(k, state));
      const auto fault = fault_of(robot, k, state, all.values.back(), RandomRobotFault::How::text, options, report);
      if (fault) return fault;
    }
    if (!options.witness) continue;
    const double error = options.witness(all);
    report.worst_witnessed = std::max(report.worst_witnessed, error);
    if (!(error <= options.bound)) return RandomRobotFault{RandomRobotFault::How::witness, "", error};
  }
  return std::nullopt;
}

}  // namespace flatdyn
