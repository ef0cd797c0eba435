// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/generator_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "report/fields.hpp"

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

double megabytes_of(long kilobytes) { return static_cast<double>(kilobytes) / 1024; }

ReportFields<Progress::Step> stage_fields(const Total& total) {
  const double all = std::max(total.seconds, 1e-9);
  return {{"stage", "stage", &Progress::Step::what},
          {"processor s", "processor_s", &Progress::Step::processor_seconds, "{:.3f}"},
          {"share", "", [all](auto& step) { return 100 * step.processor_seconds / all; }, "{:.0f} %"},
          {"peak MB so far", "", [](auto& step) { return megabytes_of(step.peak_kilobytes); }, "{:.0f}"},
          {"", "peak_kilobytes", &Progress::Step::peak_kilobytes}};
}

ReportFields<OptimisedFunction> function_fields(const GeneratorCost& cost) {
  const auto seconds_to = [&cost](const char* what) {
    return [&cost, what](const OptimisedFunction& each) { return seconds_of(cost.steps, what + each.function.name); };
  };
  return {{"function", "function", [](auto& each) { return each.function.name; }},
          {"derivation s", "derivation_s", seconds_to(kDeriving), "{:.3f}"},
          {"passes s", "passes_s", seconds_to(kOptimising), "{:.3f}"},
          {"mul", "mul", [](auto& each) { return count_operations(each.function).multiplications; }},
          {"add", "add", [](auto& each) { return count_operations(each.function).additions; }}};
}

}  // namespace

std::string generator_text(const GeneratorCost& cost) {
  const Total total = total_of(cost.steps);
  return fmt::format("{}: {:.2f} s of the processor, {:.0f} MB\n\n{}\n{}", cost.robot, total.seconds,
                     megabytes_of(total.kilobytes), table_of(stage_fields(total), stages_of_steps(cost.steps)),
                     table_of(function_fields(cost), cost.functions));
}

ordered_json generator_json(const GeneratorCost& cost) {
  const Total total = total_of(cost.steps);
  return {{"robot", cost.robot},
          {"processor_s", total.seconds},
          {"peak_kilobytes", total.kilobytes},
          {"stages", objects_of(stage_fields(total), stages_of_steps(cost.steps))},
          {"functions", objects_of(function_fields(cost), cost.functions)}};
}

}  // namespace flatdyn
