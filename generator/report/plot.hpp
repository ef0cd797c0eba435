// SPDX-License-Identifier: GPL-2.0-or-later
// Curves as a picture for people, drawn by gnuplot.
#pragma once

#include <string>
#include <vector>

namespace flatdyn {

struct Series {
  std::string name;
  std::vector<double> x, y;
  bool is_guide = false;  // a thin line among the points of a cloud; in a plane, an arm with its joints
};

enum class PanelStyle {
  curves,
  marked,  // logarithmic axes; points on the curves, x marked where the first has one
  cloud,   // logarithmic axes; points
  steps,   // x logarithmic; a histogram's outline
  plane,   // both axes of one scale; higher than the others
};

struct Panel {
  std::string title, x_label, y_label;
  std::vector<Series> series;
  PanelStyle style = PanelStyle::curves;
  std::string if_empty = {};  // why, where none of its series has a number that its axes have a place for
};

enum class PictureFormat {
  svg,  // without background, in colours for white and for dark pages
  png,  // on white, twice as many pixels as the SVG is wide and high
};

// Panels below each other in one picture. What has no number that its axes have a place for (zero has none on a
// logarithmic one) says that there is nothing to plot. The same input gives the same bytes. Throws Failure(io) where
// there is no gnuplot.
std::string plot(const std::string& title, const std::vector<Panel>& panels, PictureFormat format);
inline std::string svg_plot(const std::string& title, const std::vector<Panel>& panels) {
  return plot(title, panels, PictureFormat::svg);
}

}  // namespace flatdyn
