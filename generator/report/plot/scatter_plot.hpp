// SPDX-License-Identifier: GPL-2.0-or-later
// Pictures of named points on logarithmic axes, drawn by gnuplot.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace flatdyn {

struct ScatterPoint {
  std::string name;
  double x = 0, y = 0;     // x > 0; y = 0 is drawn below all others, marked "exact"
  std::size_t colour = 0;  // index into kPlotColours
  bool is_hollow = false;
  bool on_front = false;  // drawn with a ring
};

struct ScatterPanel {
  std::string title, x_label, y_label;
  std::vector<ScatterPoint> points;
};

// Draws panels below each other in one SVG, like plot(). Points that are not finite are left out; a panel without
// points says that there is nothing to plot. Throws Failure(io) if there is no gnuplot.
std::string svg_scatter(const std::string& title, const std::vector<ScatterPanel>& panels);

}  // namespace flatdyn
