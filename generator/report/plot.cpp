// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/plot.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "report/gnuplot.hpp"

namespace flatdyn {
namespace {

namespace fs = std::filesystem;

constexpr int kWidth = 860, kPanelHeight = 250, kPlaneHeight = 620, kTitleHeight = 40;
constexpr std::size_t kColourCount = std::size(kPlotColours);

// gnuplot fails where it is given no number that its axes have a place for; nearer to the largest double its ranges
// overflow.
constexpr double kLargestDrawn = 1e300;
// Parts of a range's ends by which these differ at the least: less, and gnuplot finds no marks between them.
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
    // An empty line breaks the curve.
    text += has_place(style, series.x[k], series.y[k]) ? fmt::format("{} {}\n", series.x[k], series.y[k]) : "\n";
  }
  return text + "EOD\n";
}

// What is named but cannot be drawn says so.
std::string key_text(PanelStyle style, const Series& series) {
  return series.name.empty() || has_place(style, series) ? series.name : series.name + ": nothing to plot";
}

// In characters: room beside the panels for the longest name and its stroke.
std::size_t key_width(const std::vector<Panel>& panels) {
  constexpr std::size_t kStroke = 8;
  std::size_t longest = 0;
  for (const Panel& panel : panels) {
    for (const Series& series : panel.series) longest = std::max(longest, key_text(panel.style, series).size());
  }
  return longest + kStroke;
}

std::string style_text(const std::vector<Panel>& panels) {
  return fmt::format(
      "set encoding utf8\n"
      "set border 3 linecolor rgb '{0}'\n"
      "set tics nomirror out scale 0.5 textcolor rgb '{0}'\n"
      "set grid linecolor rgb '{0}' linewidth 0.4 dashtype 3\n"
      "set key outside right top Left reverse samplen 1.5 width 1 noenhanced textcolor rgb '{0}'\n"
      "set lmargin 10\nset rmargin {1}\nset tmargin 2\nset bmargin 3\n"
      "set autoscale xfix\nset offsets 0, 0, graph 0.04, graph 0.04\n",
      kPlotInk, key_width(panels));
}

std::string drawn_with(PanelStyle style, const Series& series, std::size_t k) {
  if (series.is_guide && style == PanelStyle::plane) {
    return fmt::format("linespoints linewidth 2.5 pointtype 7 pointsize 0.7 linecolor rgb '{}'", kPlotInk);
  }
  if (series.is_guide) return fmt::format("lines linewidth 1 dashtype 2 linecolor rgb '{}'", kPlotInk);
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

std::string axes_text(const Panel& panel) {
  switch (panel.style) {
    case PanelStyle::curves:
      return "unset logscale\nset xtics autofreq\n";
    case PanelStyle::marked:
      return fmt::format("set logscale xy\nset offsets 0, 0, 0, 0\nset xtics {}\n", marks_text(panel));
    case PanelStyle::cloud:
      return "set logscale xy\nset offsets 0, 0, 0, 0\nset xtics autofreq\nset format '10^{%T}'\n";
    case PanelStyle::steps:
      return "unset logscale\nset logscale x 2\nset offsets 0, 0, 0, 0\nset xtics autofreq\nset format '%g'\n";
    case PanelStyle::plane:
      return "unset logscale\nset xtics autofreq\nset size ratio -1\n";
  }
  return "";
}

// For one axis of one plot; "[]" leaves it to gnuplot.
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

// Where curves would be, above the middle: a guide may go through that.
std::string empty_label(const Panel& panel) {
  return fmt::format("set label 1 {} at graph 0.02, graph 0.85 left front noenhanced textcolor rgb '{}'\n",
                     gnuplot_string("nothing to plot" + (panel.if_empty.empty() ? "" : ": " + panel.if_empty)),
                     kPlotInk);
}

// A frame, where there is no number that could give it one.
std::string plot_command(const Panel& panel, const std::vector<std::string>& curves) {
  const bool is_empty = std::none_of(panel.series.begin(), panel.series.end(),
                                     [&](const Series& series) { return has_place(panel.style, series); });
  if (is_empty)
    return fmt::format("plot [1:10] [1:10] {}\n",
                       curves.empty() ? "NaN notitle" : fmt::format("{}", fmt::join(curves, ", ")));
  return fmt::format("plot {} {} {}\n", range_text(panel, &Series::x), range_text(panel, &Series::y),
                     fmt::join(curves, ", "));
}

std::string panel_text(const Panel& panel, std::size_t index) {
  std::string text = gnuplot_label("title", panel.title, "offset 0,-0.5") + gnuplot_label("xlabel", panel.x_label) +
                     gnuplot_label("ylabel", panel.y_label) + axes_text(panel);
  std::vector<std::string> curves;
  bool is_empty = true;
  for (std::size_t k = 0; k < panel.series.size(); ++k) {
    const Series& series = panel.series[k];
    const bool is_drawn = has_place(panel.style, series);
    const std::string name = fmt::format("$panel{}_{}", index, k);
    if (is_drawn) text += data_text(panel.style, series, name);
    if (is_drawn && !series.is_guide) is_empty = false;
    curves.push_back(fmt::format("{} with {} title {}", is_drawn ? name : "NaN", drawn_with(panel.style, series, k),
                                 gnuplot_string(key_text(panel.style, series))));
  }
  if (is_empty) text += empty_label(panel);
  return text + plot_command(panel, curves) + (is_empty ? "unset label 1\n" : "");
}

// All panels have the height that one of them needs.
int panel_height(const std::vector<Panel>& panels) {
  const bool has_plane =
      std::any_of(panels.begin(), panels.end(), [](const Panel& panel) { return panel.style == PanelStyle::plane; });
  return has_plane ? kPlaneHeight : kPanelHeight;
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
  const int count = static_cast<int>(panels.size());
  std::string text = terminal_text(format, kTitleHeight + count * panel_height(panels)) +
                     fmt::format("set output {}\n", gnuplot_string(output.string()));
  text += style_text(panels);
  text += fmt::format("set multiplot layout {},1 title {} noenhanced textcolor rgb '{}' font ',15'\n", count,
                      gnuplot_string(title), kPlotInk);
  for (std::size_t k = 0; k < panels.size(); ++k) text += panel_text(panels[k], k);
  return text + "unset multiplot\n";
}

}  // namespace

std::string plot(const std::string& title, const std::vector<Panel>& panels, PictureFormat format) {
  const std::vector<Panel> drawn = panels.empty() ? std::vector<Panel>(1) : panels;
  return gnuplot_picture([&](const fs::path& output) { return script_text(title, drawn, format, output); });
}

}  // namespace flatdyn
