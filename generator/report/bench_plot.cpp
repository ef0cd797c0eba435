// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/bench_plot.hpp"

#include <fmt/format.h>

#include "report/plot/scatter_plot.hpp"

namespace flatdyn {
namespace {

// The index of the row's colour: blue for double, orange for float, green for peers.
std::size_t colour_of(const BenchRow& row) {
  if (row.is_peer) return 2;
  return row.variant.find("float") != std::string::npos ? 1 : 0;
}

ScatterPanel panel_of(const BenchReport& report, const BenchFunction& function) {
  ScatterPanel panel{fmt::format("{}, {}: {}", report.robot, function.name, to_string(function.operations)),
                     "ns per call (in a batch: per state)",
                     "error, p99, in last places",
                     {}};
  for (const BenchRow& row : function.rows) {
    panel.points.push_back(
        {row.variant, row.time.median, row.scaled.percentile_99, colour_of(row), !row.is_whole, row.on_front});
  }
  return panel;
}

}  // namespace

std::string bench_plot(const std::vector<BenchReport>& reports) {
  std::vector<ScatterPanel> panels;
  for (const BenchReport& report : reports) {
    for (const BenchFunction& function : report.functions) panels.push_back(panel_of(report, function));
  }
  return svg_scatter("Time against error. Rings: the front. Diamonds: sines and cosines, or a stage, given", panels);
}

}  // namespace flatdyn
