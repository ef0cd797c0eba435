// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/family_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/diagnostics/table.hpp"
#include "report/plot/plot.hpp"

namespace flatdyn {
namespace {

using nlohmann::ordered_json;

std::string digits(double value) { return fmt::format("{:.2g}", value); }

std::string verdict(const FamilyReport& report, const StressRow& row) {
  const std::string text = row.lost.ratio > report.options.ratio ? "LOST" : row.passed ? "ok" : "LARGE";
  return row.refused > 0 ? fmt::format("{} ({} of {} refused)", text, row.refused, row.tried) : text;
}

std::vector<std::string> series_names(const FamilyReport& report, const std::string& scalar) {
  std::vector<std::string> names;
  for (const FamilyRow& row : report.rows) {
    if (row.found.scalar != scalar) continue;
    if (std::find(names.begin(), names.end(), row.found.function) == names.end()) names.push_back(row.found.function);
  }
  return names;
}

// The largest error of all members with the same parameter, as a curve.
Series series_of(const FamilyReport& report, const std::string& function, const std::string& scalar, bool reference) {
  std::map<double, double> worst;
  for (const FamilyRow& row : report.rows) {
    if (row.found.function != function || row.found.scalar != scalar) continue;
    double& error = worst[row.parameter];
    error = std::max(error, reference ? row.found.worst.reference : row.found.worst.error.scaled);
  }
  Series series{reference ? function + ", reference" : function, {}, {}};
  for (const auto& [parameter, error] : worst) {
    series.x.push_back(parameter);
    series.y.push_back(std::max(error, 1e-3));
  }
  return series;
}

}  // namespace

std::string family_text(const FamilyReport& report) {
  std::vector<std::vector<std::string>> rows = {
      {"robot", "joints", "function", "scalar", "random: max", "edge", "worst", "condition", "reference", "ratio", ""}};
  for (const FamilyRow& each : report.rows) {
    const StressRow& row = each.found;
    rows.push_back({each.label, std::to_string(each.joints), row.function, row.scalar, digits(row.random.largest),
                    digits(row.edge), digits(row.worst.error.scaled), digits(row.worst.error.condition),
                    digits(row.worst.reference), digits(row.lost.ratio), verdict(report, row)});
  }
  std::string text = fmt::format("{}\n\n{}\n", report.family, aligned_table(rows));
  for (const std::string& line : report.left_out) text += "left out: " + line + "\n";
  return text;
}

ordered_json family_json(const FamilyReport& report) {
  ordered_json json = {{"family", report.family},
                       {"seed", report.options.seed},
                       {"passed", report.passed()},
                       {"left_out", report.left_out},
                       {"rows", ordered_json::array()}};
  for (const FamilyRow& each : report.rows) {
    const StressRow& row = each.found;
    json["rows"].push_back({{"robot", each.label},
                            {"parameter", each.parameter},
                            {"joints", each.joints},
                            {"function", row.function},
                            {"scalar", row.scalar},
                            {"states", row.states},
                            {"tried", row.tried},
                            {"refused", row.refused},
                            {"random", {{"p99", row.random.percentile_99}, {"max", row.random.largest}}},
                            {"edge_max", row.edge},
                            {"worst", row.worst.error.scaled},
                            {"condition", row.worst.error.condition},
                            {"reference", row.worst.reference},
                            {"ratio", row.lost.ratio},
                            {"passed", row.passed}});
  }
  return json;
}

std::string family_plot(const FamilyReport& report) {
  std::vector<Panel> panels;
  for (const char* scalar : {"double", "float"}) {
    Panel panel{fmt::format("worst scaled error, {}", scalar), "", "last places of the terms", {}, PanelStyle::marked};
    for (const std::string& function : series_names(report, scalar)) {
      for (const bool reference : {false, true}) {
        panel.series.push_back(series_of(report, function, scalar, reference));
      }
    }
    if (!panel.series.empty()) panels.push_back(std::move(panel));
  }
  if (!panels.empty()) panels.back().x_label = report.family == "chains" ? "joints" : report.family;
  return svg_plot("Family " + report.family, panels);
}

}  // namespace flatdyn
