// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/random_robots_report.hpp"

#include <fmt/format.h>

#include "base/diagnostics/table.hpp"

namespace flatdyn {

std::string random_robots_text(const RandomRobotsReport& report) {
  const RandomRobotsOptions& options = report.options;
  std::vector<std::vector<std::string>> rows = {{"function", "worst scaled error"}};
  for (std::size_t k = 0; k < options.functions.size(); ++k) {
    rows.push_back({options.functions[k], fmt::format("{:.2g}", report.worst[k])});
  }
  std::string text = fmt::format(
      "random: {} robots from seed {}, of {} joints in all, {} of them chains; at {} states each\n"
      "text carried out of all of them, compiled of {}; as generate makes them {}, else in drawn ways\n\n{}\n",
      report.robots, options.seed, report.joints, report.chains, options.states, report.compiled, report.usual,
      aligned_table(rows));
  for (const RandomRobotFailure& failure : report.failures) {
    text += fmt::format("\nFAILED: robot {}: {}\n\n{}", failure.seed, to_string(failure.first), failure.file);
  }
  return text + fmt::format("\n{} failed; largest error allowed {:.3g}\n", report.failures.size(), options.bound);
}

nlohmann::ordered_json random_robots_json(const RandomRobotsReport& report) {
  const RandomRobotsOptions& options = report.options;
  nlohmann::ordered_json json = {{"family", "random"},          {"seed", options.seed},
                                 {"robots", report.robots},     {"joints", report.joints},
                                 {"chains", report.chains},     {"states", options.states},
                                 {"compiled", report.compiled}, {"as_generated", report.usual},
                                 {"bound", options.bound},      {"passed", report.passed()}};
  for (std::size_t k = 0; k < options.functions.size(); ++k) json["worst"][options.functions[k]] = report.worst[k];
  json["failures"] = nlohmann::ordered_json::array();
  for (const RandomRobotFailure& failure : report.failures) {
    json["failures"].push_back({{"seed", failure.seed}, {"what", to_string(failure.last)}, {"robot", failure.file}});
  }
  return json;
}

}  // namespace flatdyn
