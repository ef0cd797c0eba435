// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/bench/abbreviations.hpp"

#include <algorithm>

#include "functions/planning/formulations.hpp"
#include "functions/planning/make_functions.hpp"
#include "graph/count.hpp"

namespace flatdyn {
namespace {

std::vector<std::string> budgets_of(const std::vector<BenchVariant>& variants) {
  std::vector<std::string> budgets;
  for (const BenchVariant& variant : variants) {
    const std::string budget = variant.budget;
    const bool is_new = std::find(budgets.begin(), budgets.end(), budget) == budgets.end();
    if (!budget.empty() && is_new) budgets.push_back(budget);
  }
  return budgets;
}

// The abbreviated functions that cost less than the whole function.
std::vector<Function> cheaper(const std::vector<Function>& abbreviated, const std::vector<Function>& functions) {
  std::vector<Function> result;
  for (const Function& each : abbreviated) {
    const auto whole = std::find_if(functions.begin(), functions.end(),
                                    [&each](const Function& function) { return function.name == each.name; });
    if (count_operations(each).arithmetic() < count_operations(*whole).arithmetic()) result.push_back(each);
  }
  return result;
}

std::vector<Function> abbreviated_functions(LoadedRobot model, const std::vector<Function>& functions,
                                            const ErrorBudget& budget, Progress& progress) {
  model.abbreviation = abbreviated(model.mechanism, budget);
  PipelineOptions options;
  for (const Function& function : functions) {
    if (has_choices(model.mechanism, function.name)) options.functions.push_back(function.name);
  }
  Diagnostics findings;
  return cheaper(functions_of(make_functions(model, options, progress, findings)), functions);
}

}  // namespace

Abbreviations abbreviations(const LoadedRobot& model, const std::vector<Function>& functions,
                            const std::vector<BenchVariant>& variants, Progress& progress) {
  Abbreviations result;
  const auto may_be_cheaper = [&model](const Function& function) {
    return has_choices(model.mechanism, function.name);
  };
  if (std::none_of(functions.begin(), functions.end(), may_be_cheaper)) return result;
  for (const std::string& budget : budgets_of(variants)) {
    if (model.abbreviation) {
      result.left_out.push_back("error budget " + budget + ": the model has one already");
      continue;
    }
    try {
      AbbreviatedFunctions made{budget, abbreviated_functions(model, functions, *error_budget(budget), progress)};
      if (made.functions.empty()) {
        result.left_out.push_back("error budget " + budget + ": it saves no operation");
      } else {
        result.made.push_back(std::move(made));
      }
    } catch (const Failure& failure) {
      if (failure.kind() != FailureKind::unsupported) throw;
      result.left_out.emplace_back(failure.what());  // "error budget: …": names no budget in particular
      break;
    }
  }
  return result;
}

}  // namespace flatdyn
