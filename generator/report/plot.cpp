// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/plot.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "report/gnuplot.hpp"

namespace flatdyn {
namespace {

namespace fs = std::filesystem;

constexpr int kWidth = 860, kPanelHeight = 250, kPlaneHeight = 620, kTitleHeight = 40;
constexpr std::size_t kColourCount = std::size(kPlotColours);

std::string data_text(const Series& series, const std::string& name) {
  std::string text = fmt::format("${} << EOD\n", name);
  for (std::size_t k = 0; k < series.x.size(); ++k) {
    // An empty line breaks the curve.
    text += std::isfinite(series.y[k]) ? fmt::format("{} {}\n", series.x[k], series.y[k]) : "\n";
  }
  return text + "EOD\n";
}

// In characters: room beside the panels for the longest name and its stroke.
std::size_t key_width(const std::vector<Panel>& panels) {
  constexpr std::size_t kStroke = 8;
  std::size_t longest = 0;
  for (const Panel& panel : panels) {
    for (const Series& series : panel.series) longest = std::max(longest, series.name.size());
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

std::string axes_text(const Panel& panel) {
  switch (panel.style) {
    case PanelStyle::curves:
      return "unset logscale\nset xtics autofreq\n";
    case PanelStyle::marked:
      return fmt::format("set logscale xy\nset offsets 0, 0, 0, 0\nset xtics ({})\n",
                         fmt::join(panel.series.front().x, ", "));
    case PanelStyle::cloud:
      return "set logscale xy\nset offsets 0, 0, 0, 0\nset xtics autofreq\nset format '10^{%T}'\n";
    case PanelStyle::steps:
      return "unset logscale\nset logscale x 2\nset offsets 0, 0, 0, 0\nset xtics autofreq\nset format '%g'\n";
    case PanelStyle::plane:
      return "unset logscale\nset xtics autofreq\nset size ratio -1\n";
  }
  return "";
}

std::string panel_text(const Panel& panel, std::size_t index) {
  std::string text = gnuplot_label("title", panel.title, "offset 0,-0.5") + gnuplot_label("xlabel", panel.x_label) +
                     gnuplot_label("ylabel", panel.y_label) + axes_text(panel);
  std::vector<std::string> curves;
  for (std::size_t k = 0; k < panel.series.size(); ++k) {
    const std::string name = fmt::format("panel{}_{}", index, k);
    text += data_text(panel.series[k], name);
    curves.push_back(fmt::format("${} with {} title {}", name, drawn_with(panel.style, panel.series[k], k),
                                 gnuplot_string(panel.series[k].name)));
  }
  return text + fmt::format("plot {}\n", fmt::join(curves, ", "));
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
  return gnuplot_picture([&](const fs::path& output) { return script_text(title, panels, format, output); });
}

}  // namespace flatdyn
