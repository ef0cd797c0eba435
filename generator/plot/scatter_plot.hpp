// SPDX-License-Identifier: GPL-2.0-or-later
// Named points on logarithmic axes as a picture for people, drawn by gnuplot.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace flatdyn {

struct ScatterPoint {
  std::string name;
  double x = 0, y = 0;     // x > 0; a y of 0 is drawn below all others, marked "exact"
  std::size_t colour = 0;  // of kPlotColours
  bool is_hollow = false;
  bool on_front = false;  // has a ring
};

struct ScatterPanel {
  std::string title, x_label, y_label;
  std::vector<ScatterPoint> points;
};

// Panels below each other in one SVG, as svg_plot does it. Points that are not finite are left out; a
// panel without points says that there is nothing to plot.
std::string svg_scatter(const std::string& title, const std::vector<ScatterPanel>& panels);

}  // namespace flatdyn
