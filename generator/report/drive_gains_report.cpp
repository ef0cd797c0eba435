// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/drive_gains_report.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/diagnostics/version.hpp"
#include "report/fields.hpp"
#include "report/numbers.hpp"
#include "report/payload_report.hpp"
#include "report/toml_string.hpp"

namespace flatdyn {
namespace {

struct JointGain {
  std::string joint, unit;  // "N m/A"; "1" where the logs have torques
  double value = 0, deviation = 0;
  std::optional<double> given;  // of the robot file or the scene

  double relative() const { return deviation / std::abs(value); }
  bool is_told() const { return std::isfinite(deviation); }
};

bool has_currents(const DriveGains& found) {
  for (const Measurement& each : found.fit.measurements) {
    for (const MeasuredLog& log : each.logs) {
      if (!log.has_currents) return false;
    }
  }
  return true;
}

// The gains of currents are the factors times those that the logs were read with.
std::vector<JointGain> gains_of(const LoadedRobot& robot, const DriveGains& found) {
  std::vector<JointGain> result;
  const Mechanism& mechanism = robot.mechanism;
  const bool are_currents = has_currents(found);
  for (Eigen::Index k = 0; k < found.factors.size(); ++k) {
    const Body& body = mechanism.joint(mechanism.base_bodies() + static_cast<int>(k));
    const double before = are_currents && body.current_to_torque ? nearest_double(*body.current_to_torque) : 1;
    result.push_back({body.joint, are_currents ? fmt::format("{}/A", torque_unit(body)) : "1",
                      found.factors(k) * before, found.standard_deviations(k) * std::abs(before),
                      body.current_to_torque ? std::optional(nearest_double(*body.current_to_torque)) : std::nullopt});
  }
  return result;
}

ReportFields<JointGain> gain_fields() {
  return {
      {"joint", "joint", &JointGain::joint},
      {"gain", "gain", &JointGain::value, "{:.6g}"},
      {"unit", "unit", &JointGain::unit},
      {"std dev", "", [](auto& each) { return deviation_text(each.deviation); }},
      {"relative", "", [](auto& each) { return each.is_told() ? fmt::format("{:.2g} %", 100 * each.relative()) : ""; }},
      {"", "standard_deviation", &JointGain::deviation}};
}

}  // namespace

std::vector<std::string> gain_warnings(const LoadedRobot& robot, const DriveGains& found) {
  constexpr double kUnsure = 0.3;
  std::vector<std::string> texts, untold;
  for (const JointGain& each : gains_of(robot, found)) {
    if (!(each.relative() < kUnsure)) untold.push_back(each.joint);
  }
  if (!untold.empty()) {
    texts.push_back(
        fmt::format("the logs hardly tell the gains of {}: the payload has to be felt there; take a heavier "
                    "one, or faster motions",
                    fmt::join(untold, ", ")));
  }
  return texts;
}

std::string describe_drive_gains(const LoadedRobot& robot, const DriveGains& found) {
  return fmt::format("{}\nThe gain is what {} multiplied by. The payload's mass is given and counts as exact.\n\n{}",
                     table_of(gain_fields(), gains_of(robot, found)),
                     has_currents(found) ? "currents are" : "the logged torques are",
                     describe_payload(robot, found.fit));
}

nlohmann::ordered_json drive_gains_json(const LoadedRobot& robot, const DriveGains& found) {
  nlohmann::ordered_json json = {{"gains", objects_of(gain_fields(), gains_of(robot, found))}};
  json["payload"] = payload_json(robot, found.fit);
  return json;
}

std::string gains_scene_text(const LoadedRobot& robot, const DriveGains& found,
                             const std::vector<std::string>& warning_texts) {
  std::string text =
      fmt::format("# The gains of the drives were identified by flatdyn {} from measured motion.\n", kProgramVersion);
  for (const std::string& warning_text : warning_texts) text += "# " + warning_text + "\n";
  text += "\n[current_to_torque]\n";
  for (const JointGain& each : gains_of(robot, found)) {
    if (each.is_told()) {
      text += fmt::format("{} = {}  # {}, std dev {}\n", toml_string(each.joint), each.value, each.unit,
                          deviation_text(each.deviation));
    }
  }
  return text;
}

}  // namespace flatdyn
