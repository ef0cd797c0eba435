// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/bench/stage_steps.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "functions/planning/make_functions.hpp"
#include "laboratory/bench/calls.hpp"

namespace flatdyn {
namespace {

OperationCount& operator+=(OperationCount& sum, const OperationCount& count) {
  sum.additions += count.additions;
  sum.multiplications += count.multiplications;
  sum.divisions += count.divisions;
  sum.trigonometric += count.trigonometric;
  return sum;
}

BenchVariant in_stages() {
  BenchVariant variant = bench_variants().front();
  variant.call_mode = CallMode::staged;
  return variant;
}

// Writes the calls of all functions of the stages, each with its entries after those of the last one.
class StepWriter {
 public:
  explicit StepWriter(const BenchSubject& subject) : subject_(subject) {}

  std::vector<StageStep> run() const {
    const Stages& stages = *subject_.stages;
    std::vector<StageStep> steps = {
        {"stages/at", "at(q)", count_operations(stages.configuration.make), fmt::format("keep({});", at()), 1}};
    if (has_motion()) {
      steps.push_back(
          {"stages/with", fmt::format("with({})", velocity()), count_operations(stages.motion.make), with(), 1});
    }
    steps.push_back(together(steps));
    steps.push_back(all("stages/apart", "one by one", bench_variants().front()));
    return steps;
  }

 private:
  bool has_motion() const { return !subject_.stages->motion.members.empty(); }

  std::string velocity() const { return velocity_argument(subject_.mechanism); }

  std::string at() const { return at_call(subject_.mechanism, bench_variants().front()); }

  std::string with() const {
    return fmt::format(
        "static const auto made = stages_of([&x](std::size_t k) {{ return {}; }});\n"
        "    keep(stage_of(made, k).with(x.{}.of(k)));",
        at(), velocity());
  }

  StageStep together(const std::vector<StageStep>& makers) const {
    StageStep step = all("stages/together", "all in stages", in_stages());
    for (const StageStep& maker : makers) step.operations += maker.operations;
    std::string stages = fmt::format("const auto configuration = {};\n    ", at());
    if (has_motion()) stages += fmt::format("const auto motion = configuration.with(x.{}.of(k));\n    ", velocity());
    step.call = stages + step.call;
    return step;
  }

  StageStep all(const std::string& name, const std::string& title, const BenchVariant& variant) const {
    StageStep step{name, title, {}, "", 0};
    for (std::size_t k = 0; k < subject_.functions.size(); ++k) {
      if (!called_function(subject_, k, in_stages())) continue;
      const CalledFunction called = *called_function(subject_, k, variant);
      step.operations += count_operations(called.function);
      step.call +=
          (step.call.empty() ? "" : "\n    ") + single_call(subject_.mechanism, called, variant, step.entries) + ";";
      step.entries += entry_count(called.function);
    }
    return step;
  }

  const BenchSubject& subject_;
};

}  // namespace

std::optional<Stages> bench_stages(const LoadedRobot& model, const std::vector<Function>& functions,
                                   const std::vector<BenchVariant>& variants, Progress& progress) {
  const bool any_staged = std::any_of(variants.begin(), variants.end(), [](const BenchVariant& variant) {
    return variant.call_mode == CallMode::staged;
  });
  std::vector<std::string> names;
  for (const Function& function : functions) {
    const std::vector<InputKind>& inputs = function.inputs;
    if (std::find(inputs.begin(), inputs.end(), InputKind::q) != inputs.end()) names.push_back(function.name);
  }
  if (!any_staged || names.empty() || model.mechanism.size() == 0) return std::nullopt;
  return stages_of(make_fusion(model, names, progress).fusion);
}

std::vector<StageStep> stage_steps(const BenchSubject& subject) {
  return subject.stages ? StepWriter(subject).run() : std::vector<StageStep>();
}

std::vector<std::string> staged_names(const BenchSubject& subject) {
  std::vector<std::string> names;
  for (std::size_t k = 0; k < subject.functions.size(); ++k) {
    if (called_function(subject, k, in_stages())) names.push_back(subject.functions[k].name);
  }
  return names;
}

}  // namespace flatdyn
