// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/budget_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "base/diagnostics/table.hpp"
#include "functions/scene/abbreviate.hpp"
#include "robot/model/rounded_up.hpp"

namespace flatdyn {
namespace {

std::string short_number(double value) { return fmt::format("{:.3g}", value); }

// The joint whose torque entry k of τ is, or the component of the force or moment on a floating base.
std::string entry_name(const Mechanism& mechanism, int k) {
  constexpr int kComponents = 3;
  if (!mechanism.is_of_base(k)) return mechanism.joint(k).joint;
  return fmt::format("base_{}{}", k < kComponents ? 'f' : 'n', "xyz"[k % kComponents]);
}

std::string bound_text(double value) { return short_number(rounded_up(value, 3)); }

}  // namespace

std::string describe_abbreviation(const LoadedRobot& model, const TorqueDeviation& seen) {
  const Abbreviation& abbreviation = *model.abbreviation;
  std::vector<std::vector<std::string>> rows = {{"joint", "budget", "proven bound", "largest seen", "unit"}};
  for (std::size_t i = 0; i < abbreviation.bound.size(); ++i) {
    const int k = static_cast<int>(i);
    const Body& body = model.mechanism.joint(k);
    rows.push_back({entry_name(model.mechanism, k), short_number(abbreviation.budget[i]),
                    bound_text(abbreviation.bound[i]), short_number(seen.largest[i]), torque_unit(body)});
  }
  return fmt::format("error budget {}: left out {}{}\n{}(largest seen: of {} random states)\n",
                     model.robot.scene.error_budget->written, abbreviation.dropped.empty() ? "nothing" : "",
                     fmt::join(names_of_dropped(abbreviation), ", "), aligned_table(rows), seen.states);
}

nlohmann::ordered_json abbreviation_json(const LoadedRobot& model, const TorqueDeviation& seen) {
  const Abbreviation& abbreviation = *model.abbreviation;
  nlohmann::ordered_json dropped = nlohmann::ordered_json::array();
  for (const DroppedParameter& parameter : abbreviation.dropped) {
    dropped.push_back({{"parameter", parameter.name}, {"value", parameter.value}, {"bound", parameter.bound}});
  }
  return {{"budget", abbreviation.budget},
          {"bound", abbreviation.bound},
          {"largest_seen", seen.largest},
          {"states", seen.states},
          {"left_out", dropped}};
}

std::string to_text(const AbbreviationReport& report, const LoadedRobot& model) {
  std::vector<std::vector<std::string>> rows = {{"function", "exactly, the abbreviated model"}};
  for (const AbbreviationReport::Entry& entry : report.exactly) {
    rows.push_back({entry.function, entry.result.equal ? "equal" : entry.result.summary()});
  }
  return aligned_table(rows) + "\n" + describe_abbreviation(model, report.seen);
}

nlohmann::ordered_json to_json(const AbbreviationReport& report, const LoadedRobot& model) {
  nlohmann::ordered_json exactly = nlohmann::ordered_json::object();
  for (const AbbreviationReport::Entry& entry : report.exactly) exactly[entry.function] = entry.result.summary();
  return {{"passed", report.passed}, {"exactly", exactly}, {"error_budget", abbreviation_json(model, report.seen)}};
}

}  // namespace flatdyn
