// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/plot/plot.hpp"
#include "report/stress_report.hpp"

namespace flatdyn {
namespace {

// The line of the inherent error: the error grows with the condition number and nothing more is lost.
Series unit_line(const std::vector<Series>& clouds) {
  double largest = 10;
  for (const Series& each : clouds) {
    for (const double x : each.x) largest = std::max(largest, x);
  }
  return {"one unit of the terms", {1, largest}, {1, largest}, SeriesKind::guide};
}

bool is_drawable(const RoundingError& point) {
  return std::isfinite(point.condition) && std::isfinite(point.relative) && point.relative > 0;
}

Panel condition_panel(const StressReport& report, const std::string& scalar) {
  Panel panel{"error against condition, " + scalar,
              "condition: size of the terms / size of the entry",
              "relative error / eps",
              {},
              PanelStyle::cloud,
              "no error above zero"};
  for (const StressRow& row : report.rows) {
    if (row.scalar != scalar) continue;
    Series series{row.function, {}, {}};
    for (const RoundingError& point : row.points) {
      if (!is_drawable(point)) continue;
      series.x.push_back(point.condition);
      series.y.push_back(point.relative);
    }
    panel.series.push_back(std::move(series));
  }
  panel.series.push_back(unit_line(panel.series));
  return panel;
}

// The scalars that the search covered.
std::vector<std::string> scalars_of(const StressReport& report) {
  std::vector<std::string> scalars;
  for (const char* scalar : {"double", "float"}) {
    const auto is_in = [&](const StressRow& row) { return row.scalar == scalar; };
    if (std::any_of(report.rows.begin(), report.rows.end(), is_in)) scalars.push_back(scalar);
  }
  return scalars;
}

bool has_errors(const StressReport& report, const std::string& scalar) {
  return std::any_of(report.rows.begin(), report.rows.end(), [&](const StressRow& row) {
    return row.scalar == scalar && std::any_of(row.points.begin(), row.points.end(), is_drawable);
  });
}

// The number of bins up to the last one that is not empty.
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
              PanelStyle::steps,
              "every random state was refused"};
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
  for (const std::string& scalar : scalars_of(report)) {
    panels.push_back(condition_panel(report, scalar));
    panels.push_back(histogram_panel(report, scalar));
  }
  return svg_plot("Rounding errors of " + report.robot, panels);
}

std::string left_out_of_plot(const StressReport& report) {
  std::string text;
  for (const std::string& scalar : scalars_of(report)) {
    if (!has_errors(report, scalar)) text += fmt::format("no error above zero in {}: nothing to plot\n", scalar);
  }
  return text;
}

}  // namespace flatdyn
