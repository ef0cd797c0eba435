// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/trace_report.hpp"

#include <fmt/format.h>

#include "base/diagnostics/table.hpp"

namespace flatdyn {
namespace {

std::string operations_text(const OperationCount& count) {
  return fmt::format("{} / {}", count.multiplications, count.additions);
}

}  // namespace

std::string describe_trace(const std::vector<Progress::Step>& steps, const std::vector<OptimisedFunction>& functions) {
  std::vector<std::vector<std::string>> stages = {{"step", "s"}};
  for (const Progress::Step& step : steps) stages.push_back({step.what, fmt::format("{:.3f}", step.seconds)});
  std::vector<std::vector<std::string>> passes = {{"function", "round", "pass", "mul / add before", "after", "ms"}};
  for (const OptimisedFunction& each : functions) {
    for (const PassRecord& record : each.passes) {
      passes.push_back({each.function.name, std::to_string(record.round), record.pass, operations_text(record.before),
                        operations_text(record.after), fmt::format("{:.2f}", record.seconds * 1e3)});
    }
  }
  return aligned_table(stages) + "\n" + aligned_table(passes);
}

}  // namespace flatdyn
