// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/bench/subject.hpp"

#include <algorithm>

#include "code/lower/limbs.hpp"
#include "laboratory/bench/calls.hpp"
#include "robot/model/identifiers.hpp"

namespace flatdyn {
namespace {

const Function* named(const std::vector<Function>& functions, const std::string& name) {
  const auto found = std::find_if(functions.begin(), functions.end(),
                                  [&name](const Function& function) { return function.name == name; });
  return found == functions.end() ? nullptr : &*found;
}

std::optional<CalledFunction> in(const std::vector<Function>& functions, const std::string& name,
                                 const std::string& scope, const std::string& receiver) {
  const Function* function = named(functions, name);
  if (function == nullptr) return std::nullopt;
  return CalledFunction{*function, scope, receiver};
}

std::string in_robot(const std::string& name) { return kBenchNamespace + ("::" + name); }

std::optional<CalledFunction> member(const std::optional<Stages>& stages, const std::string& name) {
  if (!stages) return std::nullopt;
  std::optional<CalledFunction> found =
      in(stages->configuration.members, name, in_robot("Configuration"), "configuration.");
  return found ? found : in(stages->motion.members, name, in_robot("Motion"), "motion.");
}

std::optional<CalledFunction> with_budget(const BenchSubject& subject, const std::string& name,
                                          const std::string& budget) {
  const std::string scope = name_space_of_budget(budget);
  for (const AbbreviatedFunctions& each : subject.abbreviated) {
    if (each.budget == budget) return in(each.functions, name, scope, scope + "::");
  }
  return std::nullopt;
}

}  // namespace

std::string name_space_of_budget(const std::string& budget) { return in_robot(cpp_identifier("budget " + budget)); }

std::string name_space_of(const BenchVariant& variant) {
  if (variant.has_lanes) return kLimbsNamespace;
  if (variant.is_native) return kNativeNamespace;
  if (variant.call_mode == CallMode::kernel) return kKernelsNamespace;
  return variant.fuses ? kFusedNamespace : kBenchNamespace;
}

CalledFunction whole_function(const Function& function, const BenchVariant& variant) {
  const std::string scope = name_space_of(variant);
  return {function, scope, scope + "::"};
}

std::optional<CalledFunction> called_function(const BenchSubject& subject, std::size_t k, const BenchVariant& variant) {
  const Function& whole = subject.functions[k];
  if (!is_made(variant, whole, subject.toolchain.has_xsimd)) return std::nullopt;
  if (variant.is_packed && !can_be_packed(whole)) return std::nullopt;
  if (variant.has_lanes && limbs_of(subject.mechanism).empty()) return std::nullopt;
  if (variant.call_mode == CallMode::staged) return member(subject.stages, whole.name);
  const std::string budget = variant.budget;
  if (!budget.empty()) return with_budget(subject, whole.name, budget);
  return whole_function(whole, variant);
}

}  // namespace flatdyn
