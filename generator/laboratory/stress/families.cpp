// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/stress/families.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/diagnostics/nearest.hpp"
#include "functions/planning/make_functions.hpp"
#include "laboratory/stress/random_robots.hpp"

namespace flatdyn {
namespace {

const FamilyEntry& entry_of(const std::string& family) {
  std::vector<std::string> names;
  for (const FamilyEntry& entry : family_table()) {
    if (family == entry.name) return entry;
    names.emplace_back(entry.name);
  }
  names.emplace_back(kRandomFamily);
  throw Failure(FailureKind::usage, "no family named \"" + family + "\"", hint_for_unknown(family, names, "families"));
}

// The functions that the robot can have: B cannot be inverted if a joint moves no mass.
std::vector<Function> functions_for(const LoadedRobot& model, const FamilyMember& member, const FamilyOptions& options,
                                    Progress& progress, FamilyReport& report) {
  std::vector<Function> functions;
  for (const std::string& name : options.functions) {
    PipelineOptions one;
    one.functions = {name};
    Diagnostics findings;
    try {
      functions.push_back(functions_of(make_functions(model, one, progress, findings)).front());
    } catch (const BadInput& bad) {
      if (bad.kind() != FailureKind::unsupported) throw;
      report.left_out.push_back(fmt::format("{}: {}", member.label, bad.diagnostics.all().front().message));
    } catch (const Failure& failure) {
      if (failure.kind() != FailureKind::unsupported) throw;
      report.left_out.push_back(fmt::format("{}: {}", member.label, failure.what()));
    }
  }
  return functions;
}

}  // namespace

bool FamilyReport::passed() const {
  return std::all_of(rows.begin(), rows.end(), [](const FamilyRow& row) { return row.found.passed; });
}

FamilyReport stress_family(const FamilyOptions& options, Progress& progress) {
  FamilyReport report{options.family, options.stress, {}, {}};
  const FamilySize size{options.robots, options.joints, options.stress.seed};
  for (FamilyMember& member : entry_of(options.family).members(size)) {
    Mechanism mechanism = make_mechanism(member.robot);
    const LoadedRobot model{std::move(member.robot), std::move(mechanism), std::nullopt, {}, ""};
    const std::vector<Function> functions = functions_for(model, member, options, progress, report);
    for (StressRow& row : stress(model.robot, model.mechanism, functions, options.stress, progress).rows) {
      report.rows.push_back({member.label, member.parameter, model.mechanism.size(), std::move(row)});
    }
  }
  return report;
}

}  // namespace flatdyn
