// SPDX-License-Identifier: GPL-2.0-or-later
// Curves as a picture for people, drawn by gnuplot.
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
  marked,  // logarithmic axes; points on the curves, x marked where the first has one
  cloud,   // logarithmic axes; points
  steps,   // x logarithmic; a histogram's outline
  plane,   // both axes of one scale; higher than the others
};

struct Note {
  double x, y;
  std::string text;
};

// What a panel shows of its plane.
struct Window {
  double left, right, bottom, top;
};

struct Panel {
  std::string title, x_label, y_label;
  std::vector<Series> series;
  PanelStyle style = PanelStyle::curves;
  std::string if_empty = {};          // why, where none of its series has a number that its axes have a place for
  bool is_half = false;               // beside another one, both without a key
  std::optional<Window> window = {};  // else as much as the series need
  std::vector<Note> notes = {};
  double cell = 0;               // edge of the squares
  std::string value_label = {};  // of their colours
  bool has_logarithmic_values = false;
};

enum class PictureFormat {
  svg,  // without background, in colours for white and for dark pages
  png,  // on white, twice as many pixels as the SVG is wide and high
};

// Panels below each other in one picture, two halves in a row. What has no number that its axes have a place for (zero
// has none on a logarithmic one) says that there is nothing to plot. The same input gives the same bytes. Throws
// Failure(io) where there is no gnuplot.
std::string plot(const std::string& title, const std::vector<Panel>& panels, PictureFormat format);
inline std::string svg_plot(const std::string& title, const std::vector<Panel>& panels) {
  return plot(title, panels, PictureFormat::svg);
}

}  // namespace flatdyn
