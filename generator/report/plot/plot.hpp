// SPDX-License-Identifier: GPL-2.0-or-later
// Pictures of curves, drawn by gnuplot.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace flatdyn {

enum class SeriesKind {
  curve,
  guide,  // thin, without a colour of its own
  arm,    // thick lines between joints
  cells,  // squares side by side, coloured by `value`
};

struct Series {
  std::string name;
  std::vector<double> x, y;
  SeriesKind kind = SeriesKind::curve;
  std::vector<double> value = {};
};

enum class PanelStyle {
  curves,
  marked,  // logarithmic axes; points on the curves, x marked where the first curve has a point
  cloud,   // logarithmic axes; points
  steps,   // logarithmic x; the outline of a histogram
  plane,   // both axes with one scale; higher than the others
};

struct Note {
  double x, y;
  std::string text;
};

// The visible part of a panel's plane.
struct Window {
  double left, right, bottom, top;
};

struct Panel {
  std::string title, x_label, y_label;
  std::vector<Series> series;
  PanelStyle style = PanelStyle::curves;
  std::string if_empty = {};          // the reason if no number of its series is within the axes
  bool is_half = false;               // beside another panel, both without a key
  std::optional<Window> window = {};  // default: the extent of the series
  std::vector<Note> notes = {};
  double cell = 0;               // edge of the squares
  std::string value_label = {};  // label of the squares' colours
  bool has_logarithmic_values = false;
};

enum class PictureFormat {
  svg,  // without background, in colours for white and for dark pages
  png,  // on white, with twice as many pixels as the SVG in both directions
};

// Draws panels below each other in one picture, with two halves in a row. A panel without a number within its axes
// (zero is not on a logarithmic one) says that there is nothing to plot. The same input gives the same bytes. Throws
// Failure(io) if there is no gnuplot.
std::string plot(const std::string& title, const std::vector<Panel>& panels, PictureFormat format);
// The same as SVG.
inline std::string svg_plot(const std::string& title, const std::vector<Panel>& panels) {
  return plot(title, panels, PictureFormat::svg);
}

}  // namespace flatdyn
