// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/generator_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/diagnostics/table.hpp"

namespace flatdyn {
namespace {

using nlohmann::ordered_json;

constexpr const char *kDeriving = "deriving ", *kOptimising = "optimising ";

std::string stage_of(const Progress::Step& step) {
  if (step.what.starts_with(kDeriving)) return "derivation";
  if (step.what.starts_with(kOptimising)) return "passes";
  return step.what;
}

// The steps of each stage together, in the order of the first ones.
std::vector<Progress::Step> stages_of_steps(const std::vector<Progress::Step>& steps) {
  std::vector<Progress::Step> stages;
  for (const Progress::Step& step : steps) {
    const std::string name = stage_of(step);
    auto stage = std::find_if(stages.begin(), stages.end(), [&](const auto& each) { return each.what == name; });
    if (stage == stages.end()) stage = stages.insert(stage, Progress::Step{name});
    stage->processor_seconds += step.processor_seconds;
    stage->peak_kilobytes = std::max(stage->peak_kilobytes, step.peak_kilobytes);
  }
  return stages;
}

double seconds_of(const std::vector<Progress::Step>& steps, const std::string& what) {
  const auto found = std::find_if(steps.begin(), steps.end(), [&](const auto& step) { return step.what == what; });
  return found == steps.end() ? 0 : found->processor_seconds;
}

struct Total {
  double seconds = 0;
  long kilobytes = 0;
};

Total total_of(const std::vector<Progress::Step>& steps) {
  Total total;
  for (const Progress::Step& step : steps) {
    total.seconds += step.processor_seconds;
    total.kilobytes = std::max(total.kilobytes, step.peak_kilobytes);
  }
  return total;
}

std::string megabytes_text(long kilobytes) { return fmt::format("{:.0f}", static_cast<double>(kilobytes) / 1024); }

}  // namespace

std::string generator_text(const GeneratorCost& cost) {
  const Total total = total_of(cost.steps);
  std::vector<std::vector<std::string>> stages = {{"stage", "processor s", "share", "peak MB so far"}};
  for (const Progress::Step& stage : stages_of_steps(cost.steps)) {
    stages.push_back({stage.what, fmt::format("{:.3f}", stage.processor_seconds),
                      fmt::format("{:.0f} %", 100 * stage.processor_seconds / std::max(total.seconds, 1e-9)),
                      megabytes_text(stage.peak_kilobytes)});
  }
  std::vector<std::vector<std::string>> functions = {{"function", "derivation s", "passes s", "mul", "add"}};
  for (const OptimisedFunction& each : cost.functions) {
    const OperationCount count = count_operations(each.function);
    functions.push_back({each.function.name,
                         fmt::format("{:.3f}", seconds_of(cost.steps, kDeriving + each.function.name)),
                         fmt::format("{:.3f}", seconds_of(cost.steps, kOptimising + each.function.name)),
                         std::to_string(count.multiplications), std::to_string(count.additions)});
  }
  return fmt::format("{}: {:.2f} s of the processor, {} MB\n\n{}\n{}", cost.robot, total.seconds,
                     megabytes_text(total.kilobytes), aligned_table(stages), aligned_table(functions));
}

ordered_json generator_json(const GeneratorCost& cost) {
  const Total total = total_of(cost.steps);
  ordered_json json = {{"robot", cost.robot},
                       {"processor_s", total.seconds},
                       {"peak_kilobytes", total.kilobytes},
                       {"stages", ordered_json::array()},
                       {"functions", ordered_json::array()}};
  for (const Progress::Step& stage : stages_of_steps(cost.steps)) {
    json["stages"].push_back(
        {{"stage", stage.what}, {"processor_s", stage.processor_seconds}, {"peak_kilobytes", stage.peak_kilobytes}});
  }
  for (const OptimisedFunction& each : cost.functions) {
    const OperationCount count = count_operations(each.function);
    json["functions"].push_back({{"function", each.function.name},
                                 {"derivation_s", seconds_of(cost.steps, kDeriving + each.function.name)},
                                 {"passes_s", seconds_of(cost.steps, kOptimising + each.function.name)},
                                 {"mul", count.multiplications},
                                 {"add", count.additions}});
  }
  return json;
}

}  // namespace flatdyn
