// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/plot/plot.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "report/plot/gnuplot.hpp"

namespace flatdyn {
namespace {

namespace fs = std::filesystem;

constexpr int kWidth = 860, kPanelHeight = 250, kPlaneHeight = 620, kTitleHeight = 40;
constexpr int kColourBarWidth = 14, kHalfMargin = 2;  // characters
constexpr std::size_t kColourCount = std::size(kPlotColours);
// Colours that are light in both themes, so that curves and ink show on both of them.
constexpr const char *kPaleCell = "#eaf2fb", *kDarkCell = "#3f7fc1";

// The largest number drawn: gnuplot fails if no number is within its axes, and its ranges overflow near the largest
// double.
constexpr double kLargestDrawn = 1e300;
// The least relative width of a range; gnuplot finds no marks in a narrower one.
constexpr double kNarrowest = 1e-9;

bool has_logarithmic_x(PanelStyle style) {
  return style == PanelStyle::marked || style == PanelStyle::cloud || style == PanelStyle::steps;
}

bool has_logarithmic_y(PanelStyle style) { return style == PanelStyle::marked || style == PanelStyle::cloud; }

bool is_on_axis(double value, bool is_logarithmic) {
  return std::abs(value) < kLargestDrawn && (!is_logarithmic || value > 0);
}

bool has_place(PanelStyle style, double x, double y) {
  return is_on_axis(x, has_logarithmic_x(style)) && is_on_axis(y, has_logarithmic_y(style));
}

bool has_place(PanelStyle style, const Series& series) {
  for (std::size_t k = 0; k < series.x.size(); ++k) {
    if (has_place(style, series.x[k], series.y[k])) return true;
  }
  return false;
}

std::string data_text(PanelStyle style, const Series& series, const std::string& name) {
  std::string text = fmt::format("{} << EOD\n", name);
  for (std::size_t k = 0; k < series.x.size(); ++k) {
    if (has_place(style, series.x[k], series.y[k])) {
      text += fmt::format("{} {}", series.x[k], series.y[k]);
      if (series.kind == SeriesKind::cells) text += fmt::format(" {}", series.value[k]);
    }
    text += '\n';  // an empty line breaks the curve
  }
  return text + "EOD\n";
}

// The name of a series in the key; it says so if nothing of it can be drawn.
std::string key_text(PanelStyle style, const Series& series) {
  return series.name.empty() || has_place(style, series) ? series.name : series.name + ": nothing to plot";
}

// The width, in characters, beside the panels for the longest name and its stroke.
std::size_t key_width(const std::vector<Panel>& panels) {
  constexpr std::size_t kStroke = 8;
  std::size_t longest = 0;
  for (const Panel& panel : panels) {
    if (panel.is_half) continue;
    for (const Series& series : panel.series) longest = std::max(longest, key_text(panel.style, series).size());
  }
  return longest + kStroke;
}

std::string style_text() {
  return fmt::format(
      "set encoding utf8\n"
      "set border 3 linecolor rgb '{0}'\n"
      "set tics nomirror out scale 0.5 textcolor rgb '{0}'\n"
      "set grid linecolor rgb '{0}' linewidth 0.4 dashtype 3\n"
      "set lmargin 10\nset tmargin 2\nset bmargin 3.5\n"
      "set autoscale xfix\nset offsets 0, 0, graph 0.04, graph 0.04\n"
      "set palette defined (0 '{1}', 1 '{2}')\nset style fill solid noborder\n",
      kPlotInk, kPaleCell, kDarkCell);
}

std::string drawn_with(PanelStyle style, const Series& series, std::size_t k) {
  switch (series.kind) {
    case SeriesKind::curve:
      break;
    case SeriesKind::guide:
      return fmt::format("lines linewidth 1 dashtype 2 linecolor rgb '{}'", kPlotInk);
    case SeriesKind::arm:
      return fmt::format("linespoints linewidth 2.5 pointtype 7 pointsize 0.7 linecolor rgb '{}'", kPlotInk);
    case SeriesKind::cells:
      return "boxxyerror linecolor palette";
  }
  const std::string colour = fmt::format("linecolor rgb '{}'", kPlotColours[k % kColourCount]);
  const std::string line = fmt::format("linewidth 1.4 {} dashtype {}", colour, k / kColourCount + 1);
  switch (style) {
    case PanelStyle::curves:
      return "lines " + line;
    case PanelStyle::marked:
      return "linespoints pointtype 7 pointsize 0.5 " + line;
    case PanelStyle::cloud:
      return fmt::format("points pointtype {} pointsize 0.35 {}", k < kColourCount ? 7 : 4, colour);
    case PanelStyle::steps:
      return "histeps " + line;
    case PanelStyle::plane:
      return "lines " + line;
  }
  return "";
}

std::string marks_text(const Panel& panel) {
  std::vector<double> marks;
  if (!panel.series.empty()) {
    const std::vector<double>& x = panel.series.front().x;
    std::copy_if(x.begin(), x.end(), std::back_inserter(marks), [](double each) { return is_on_axis(each, true); });
  }
  return marks.empty() ? "autofreq" : fmt::format("({})", fmt::join(marks, ", "));
}

// The distance of marks, 1, 2 or 5 times a power of ten, such that a window has three to seven of them and their
// numbers have room.
double mark_step(const Window& window) {
  const double rough = (window.right - window.left) / 7, power = std::pow(10, std::floor(std::log10(rough)));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (rough <= step * power) return step * power;
  }
  return 10 * power;
}

std::string axes_text(const Panel& panel) {
  switch (panel.style) {
    case PanelStyle::curves:
      return "unset logscale\nset xtics autofreq\nset ytics autofreq\n";
    case PanelStyle::marked:
      return fmt::format("set logscale xy\nset offsets 0, 0, 0, 0\nset xtics {}\n", marks_text(panel));
    case PanelStyle::cloud:
      return "set logscale xy\nset offsets 0, 0, 0, 0\nset xtics autofreq\nset format '10^{%T}'\n";
    case PanelStyle::steps:
      return "unset logscale\nset logscale x 2\nset offsets 0, 0, 0, 0\nset xtics autofreq\nset format '%g'\n";
    case PanelStyle::plane: {
      const std::string step = panel.window ? fmt::format("{}", mark_step(*panel.window)) : "autofreq";
      return fmt::format("unset logscale\nset xtics {0}\nset ytics {0}\n", step);
    }
  }
  return "";
}

// The range of one axis of one plot; "[]" leaves it to gnuplot.
std::string range_text(const Panel& panel, const std::vector<double> Series::*numbers) {
  double low = kLargestDrawn, high = -kLargestDrawn;
  for (const Series& series : panel.series) {
    for (std::size_t k = 0; k < series.x.size(); ++k) {
      if (!has_place(panel.style, series.x[k], series.y[k])) continue;
      low = std::min(low, (series.*numbers)[k]);
      high = std::max(high, (series.*numbers)[k]);
    }
  }
  const double room = kNarrowest * std::max(std::abs(low), std::abs(high));
  const bool is_narrow = low < high && high - low < room;
  return is_narrow ? fmt::format("[{}:{}]", low - room, high + room) : "[]";
}

// The label of an empty panel, above the middle, where a guide may pass.
std::string empty_label(const Panel& panel) {
  return fmt::format("set label 1 {} at graph 0.02, graph 0.85 left front noenhanced textcolor rgb '{}'\n",
                     gnuplot_string("nothing to plot" + (panel.if_empty.empty() ? "" : ": " + panel.if_empty)),
                     kPlotInk);
}

// The plot command, with a fixed frame if no number determines one.
std::string plot_command(const Panel& panel, const std::vector<std::string>& curves) {
  const bool is_empty = std::none_of(panel.series.begin(), panel.series.end(),
                                     [&](const Series& series) { return has_place(panel.style, series); });
  if (is_empty)
    return fmt::format("plot [1:10] [1:10] {}\n",
                       curves.empty() ? "NaN notitle" : fmt::format("{}", fmt::join(curves, ", ")));
  if (panel.window) {
    const auto& [left, right, bottom, top] = *panel.window;
    return fmt::format("plot [{}:{}] [{}:{}] {}\n", left, right, bottom, top, fmt::join(curves, ", "));
  }
  return fmt::format("plot {} {} {}\n", range_text(panel, &Series::x), range_text(panel, &Series::y),
                     fmt::join(curves, ", "));
}

std::string notes_text(const Panel& panel) {
  std::string text;
  for (const Note& note : panel.notes) {
    text += fmt::format("set label {} at {}, {} center front noenhanced textcolor rgb '{}'\n",
                        gnuplot_string(note.text), note.x, note.y, kPlotInk);
  }
  return text;
}

std::string key_style(const Panel& panel) {
  if (panel.is_half) return "unset key\n";
  return fmt::format("set key outside right top Left reverse samplen 1.5 width 1 noenhanced textcolor rgb '{}'\n",
                     kPlotInk);
}

// The columns to plot; squares extend by half their edge in both directions.
std::string columns_text(const Panel& panel, const Series& series) {
  return series.kind == SeriesKind::cells ? fmt::format(" using 1:2:({0}):({0}):3", panel.cell / 2) : "";
}

std::string panel_text(const Panel& panel, std::size_t index) {
  std::string text = gnuplot_label("title", panel.title, "offset 0,-0.5") + gnuplot_label("xlabel", panel.x_label) +
                     gnuplot_label("ylabel", panel.y_label) + gnuplot_label("cblabel", panel.value_label) +
                     axes_text(panel) + notes_text(panel) + key_style(panel) +
                     (panel.has_logarithmic_values ? "set logscale cb\n" : "unset logscale cb\n");
  std::vector<std::string> curves;
  bool is_empty = true;
  for (std::size_t k = 0; k < panel.series.size(); ++k) {
    const Series& series = panel.series[k];
    const bool is_drawn = has_place(panel.style, series);
    const std::string name = fmt::format("$panel{}_{}", index, k);
    if (is_drawn) text += data_text(panel.style, series, name);
    if (is_drawn && series.kind != SeriesKind::guide && series.kind != SeriesKind::arm) is_empty = false;
    curves.push_back(fmt::format("{} with {} title {}", is_drawn ? name + columns_text(panel, series) : "NaN",
                                 drawn_with(panel.style, series, k), gnuplot_string(key_text(panel.style, series))));
  }
  if (is_empty) text += empty_label(panel);
  return text + plot_command(panel, curves) + "unset label\n";
}

// With room for the whole key in one column: a second column would lie over the curves.
int key_height(const Panel& panel) {
  constexpr int kLine = 19, kMargins = 100;
  return panel.is_half ? 0 : kLine * static_cast<int>(panel.series.size()) + kMargins;
}

int panel_height(const Panel& panel) {
  if (panel.style != PanelStyle::plane) return std::max(kPanelHeight, key_height(panel));
  return panel.is_half ? kWidth / 2 : kPlaneHeight;
}

// Rows of panels, from the top.
std::vector<std::vector<const Panel*>> rows_of(const std::vector<Panel>& panels) {
  std::vector<std::vector<const Panel*>> rows;
  for (const Panel& panel : panels) {
    const bool joins = panel.is_half && !rows.empty() && rows.back().size() == 1 && rows.back().front()->is_half;
    if (joins) {
      rows.back().push_back(&panel);
    } else {
      rows.push_back({&panel});
    }
  }
  return rows;
}

int row_height(const std::vector<const Panel*>& row) {
  int height = 0;
  for (const Panel* panel : row) height = std::max(height, panel_height(*panel));
  return height;
}

bool has_cells(const Panel& panel) {
  return std::any_of(panel.series.begin(), panel.series.end(),
                     [](const Series& series) { return series.kind == SeriesKind::cells; });
}

std::string terminal_text(PictureFormat format, int height) {
  if (format == PictureFormat::svg) {
    return fmt::format("set terminal svg size {},{} dynamic rounded font 'sans-serif,12'\n", kWidth, height);
  }
  return fmt::format(
      "set terminal pngcairo size {},{} rounded background '#ffffff' fontscale 2 linewidth 2 pointscale 2 "
      "font 'sans-serif,12'\n",
      2 * kWidth, 2 * height);
}

std::string script_text(const std::string& title, const std::vector<Panel>& panels, PictureFormat format,
                        const fs::path& output) {
  const std::vector<std::vector<const Panel*>> rows = rows_of(panels);
  int height = kTitleHeight;
  for (const auto& row : rows) height += row_height(row);
  std::string text =
      terminal_text(format, height) + fmt::format("set output {}\n", gnuplot_string(output.string())) + style_text() +
      fmt::format("set multiplot title {} noenhanced textcolor rgb '{}' font ',15'\n", gnuplot_string(title), kPlotInk);
  double below = height - kTitleHeight;
  std::size_t index = 0;
  for (const auto& row : rows) {
    below -= row_height(row);
    for (std::size_t k = 0; k < row.size(); ++k) {
      const Panel& panel = *row[k];
      const auto margin = panel.is_half      ? kHalfMargin
                          : has_cells(panel) ? kColourBarWidth
                                             : static_cast<int>(key_width(panels));
      text += fmt::format("set origin {},{}\nset size {} {},{}\nset rmargin {}\n", 0.5 * static_cast<double>(k),
                          below / height, panel.style == PanelStyle::plane ? "ratio -1" : "noratio",
                          panel.is_half ? 0.5 : 1.0, static_cast<double>(row_height(row)) / height, margin);
      text += panel_text(panel, index++);
    }
  }
  return text + "unset multiplot\n";
}

}  // namespace

std::string plot(const std::string& title, const std::vector<Panel>& panels, PictureFormat format) {
  const std::vector<Panel> drawn = panels.empty() ? std::vector<Panel>(1) : panels;
  return gnuplot_picture([&](const fs::path& output) { return script_text(title, drawn, format, output); });
}

}  // namespace flatdyn
