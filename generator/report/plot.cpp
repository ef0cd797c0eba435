// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/plot.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "diagnostics/diagnostics.hpp"
#include "diagnostics/temporary_folder.hpp"

namespace flatdyn {
namespace {

namespace fs = std::filesystem;

constexpr int kWidth = 860, kPanelHeight = 250, kTitleHeight = 40;
// Readable on white and on black alike.
constexpr const char* kInk = "#8a8a8a";
// After Okabe and Ito, distinct to the colour-blind; blue and orange moved to a middle lightness, their yellow, which
// white swallows, left out.
constexpr const char* kColours[] = {"#2b83ca", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#c98a00", "#8f7ee0"};
constexpr std::size_t kColourCount = std::size(kColours);

// A text of gnuplot: within single quotes only the quote itself is special.
std::string gnuplot_string(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'') result += c;
    result += c == '\n' ? ' ' : c;
  }
  return result + "'";
}

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
      kInk, key_width(panels));
}

std::string label_text(const std::string& what, const std::string& text, const std::string& options = "") {
  return fmt::format("set {} {} {} noenhanced textcolor rgb '{}'\n", what, gnuplot_string(text), options, kInk);
}

std::string panel_text(const Panel& panel, std::size_t index) {
  std::string text = label_text("title", panel.title, "offset 0,-0.5") + label_text("xlabel", panel.x_label) +
                     label_text("ylabel", panel.y_label);
  std::vector<std::string> curves;
  for (std::size_t k = 0; k < panel.series.size(); ++k) {
    const std::string name = fmt::format("panel{}_{}", index, k);
    text += data_text(panel.series[k], name);
    curves.push_back(fmt::format("${} with lines linewidth 1.4 linecolor rgb '{}' dashtype {} title {}", name,
                                 kColours[k % kColourCount], k / kColourCount + 1,
                                 gnuplot_string(panel.series[k].name)));
  }
  return text + fmt::format("plot {}\n", fmt::join(curves, ", "));
}

std::string script_text(const std::string& title, const std::vector<Panel>& panels, const fs::path& output) {
  const int count = static_cast<int>(panels.size());
  std::string text = fmt::format("set terminal svg size {},{} dynamic rounded font 'sans-serif,12'\nset output {}\n",
                                 kWidth, kTitleHeight + count * kPanelHeight, gnuplot_string(output.string()));
  text += style_text(panels);
  text += fmt::format("set multiplot layout {},1 title {} noenhanced textcolor rgb '{}' font ',15'\n", count,
                      gnuplot_string(title), kInk);
  for (std::size_t k = 0; k < panels.size(); ++k) text += panel_text(panels[k], k);
  return text + "unset multiplot\n";
}

std::string content_of(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

}  // namespace

std::string svg_plot(const std::string& title, const std::vector<Panel>& panels) {
  if (std::system("gnuplot --version > /dev/null 2>&1") != 0) {
    throw Failure(ExitCode::io, "no plot: gnuplot cannot be run", "install gnuplot-nox");
  }
  const TemporaryFolder folder;
  const fs::path script = folder.path() / "plot.gp", output = folder.path() / "plot.svg", log = folder.path() / "log";
  std::ofstream(script, std::ios::binary) << script_text(title, panels, output);
  const std::string command = fmt::format("gnuplot '{}' > /dev/null 2> '{}'", script.string(), log.string());
  if (std::system(command.c_str()) != 0) throw Failure(ExitCode::io, "gnuplot failed: " + content_of(log));
  return content_of(output);
}

}  // namespace flatdyn
