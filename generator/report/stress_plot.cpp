// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/plot.hpp"
#include "report/stress_report.hpp"

namespace flatdyn {
namespace {

// Where errors grow as the condition does, nothing but the inherent is lost.
Series unit_line(const std::vector<Series>& clouds) {
  double largest = 10;
  for (const Series& each : clouds) {
    for (const double x : each.x) largest = std::max(largest, x);
  }
  return {"one unit of the terms", {1, largest}, {1, largest}, true};
}

Panel condition_panel(const StressReport& report, const std::string& scalar) {
  Panel panel{"error against condition, " + scalar,
              "condition: size of the terms / size of the entry",
              "relative error / eps",
              {},
              PanelStyle::cloud};
  for (const StressRow& row : report.rows) {
    if (row.scalar != scalar) continue;
    Series series{row.function, {}, {}};
    for (const StressError& point : row.points) {
      if (!std::isfinite(point.condition) || !std::isfinite(point.relative) || !(point.relative > 0)) continue;
      series.x.push_back(point.condition);
      series.y.push_back(point.relative);
    }
    if (!series.x.empty()) panel.series.push_back(std::move(series));
  }
  panel.series.push_back(unit_line(panel.series));
  return panel;
}

// Up to the last one that has something.
int bins_to_show(const StressReport& report) {
  int last = 20;
  for (const StressRow& row : report.rows) {
    for (int bin = last; bin < kStressBins; ++bin) {
      if (row.histogram[static_cast<std::size_t>(bin)] > 0) last = bin;
    }
  }
  return std::min(last + 2, kStressBins);
}

Panel histogram_panel(const StressReport& report, const std::string& scalar) {
  Panel panel{"scaled errors at random states, " + scalar,
              "units of the last place of the terms' size",
              "part of the states",
              {},
              PanelStyle::steps};
  for (const StressRow& row : report.rows) {
    if (row.scalar != scalar || row.states == 0) continue;
    Series series{row.function, {}, {}};
    for (int bin = 0; bin < bins_to_show(report); ++bin) {
      series.x.push_back(stress_bin_start(bin) * std::exp2(0.25));
      series.y.push_back(static_cast<double>(row.histogram[static_cast<std::size_t>(bin)]) /
                         static_cast<double>(row.states));
    }
    panel.series.push_back(std::move(series));
  }
  return panel;
}

}  // namespace

std::string stress_plot(const StressReport& report) {
  std::vector<Panel> panels;
  for (const char* scalar : {"double", "float"}) {
    panels.push_back(condition_panel(report, scalar));
    panels.push_back(histogram_panel(report, scalar));
  }
  return svg_plot("Rounding errors of " + report.robot, panels);
}

}  // namespace flatdyn
