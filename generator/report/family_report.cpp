// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/family_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "report/fields.hpp"
#include "report/plot/plot.hpp"

namespace flatdyn {
namespace {

using nlohmann::ordered_json;

std::string verdict(const FamilyReport& report, const StressRow& row) {
  const std::string text = row.lost.ratio > report.options.ratio ? "LOST" : row.passed ? "ok" : "LARGE";
  return row.refused > 0 ? fmt::format("{} ({} of {} refused)", text, row.refused, row.tried) : text;
}

ReportFields<FamilyRow> family_fields(const FamilyReport& report) {
  return {{"robot", "robot", &FamilyRow::label},
          {"", "parameter", &FamilyRow::parameter},
          {"joints", "joints", &FamilyRow::joints},
          {"function", "function", [](auto& row) { return row.found.function; }},
          {"scalar", "scalar", [](auto& row) { return row.found.scalar; }},
          {"", "states", [](auto& row) { return row.found.states; }},
          {"", "tried", [](auto& row) { return row.found.tried; }},
          {"", "refused", [](auto& row) { return row.found.refused; }},
          {"", "random.p99", [](auto& row) { return row.found.random.percentile_99; }},
          {"random: max", "random.max", [](auto& row) { return row.found.random.largest; }, "{:.2g}"},
          {"edge", "edge_max", [](auto& row) { return row.found.edge; }, "{:.2g}"},
          {"worst", "worst", [](auto& row) { return row.found.worst.error.scaled; }, "{:.2g}"},
          {"condition", "condition", [](auto& row) { return row.found.worst.error.condition; }, "{:.2g}"},
          {"reference", "reference", [](auto& row) { return row.found.worst.reference; }, "{:.2g}"},
          {"ratio", "ratio", [](auto& row) { return row.found.lost.ratio; }, "{:.2g}"},
          {" ", "", [&report](auto& row) { return verdict(report, row.found); }},
          {"", "passed", [](auto& row) { return row.found.passed; }}};
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
  std::string text = fmt::format("{}\n\n{}\n", report.family, table_of(family_fields(report), report.rows));
  for (const std::string& line : report.left_out) text += "left out: " + line + "\n";
  return text;
}

ordered_json family_json(const FamilyReport& report) {
  return {{"family", report.family},
          {"seed", report.options.seed},
          {"passed", report.passed()},
          {"left_out", report.left_out},
          {"rows", objects_of(family_fields(report), report.rows)}};
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
