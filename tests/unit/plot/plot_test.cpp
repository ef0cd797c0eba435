// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/plot/plot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/diagnostics/diagnostics.hpp"

namespace flatdyn::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::vector<Panel> panels() {
  return {{"it's %1 {a_b}", "t in s", "q", {{"joint_1'`$x", {0, 1, 2}, {0, 1, 0}}, {"zwei", {0, 1}, {1, 2}}}},
          {"second", "t in s", "", {{"gap", {0, 1, 2, 3, 4}, {0, 1, NAN, 1, 0}}}}};
}

TEST(SvgPlot, ShowsTitlesAndNamesAsTheyAre) {
  const std::string svg = svg_plot("robot_1: plot", panels());
  for (const char* text : {"robot_1: plot", "it's %1 {a_b}", "joint_1'`$x", "zwei", "second", "t in s", "</svg>"}) {
    EXPECT_THAT(svg, HasSubstr(text));
  }
}

TEST(SvgPlot, IsReadableOnWhiteAndOnBlack) {
  const std::string svg = svg_plot("plot", panels());
  EXPECT_THAT(svg, Not(HasSubstr("fill=\"#ffffff\"")));
  EXPECT_THAT(svg, Not(HasSubstr("fill = 'black'")));
}

TEST(SvgPlot, GivesTheSameBytesInEveryRun) { EXPECT_EQ(svg_plot("plot", panels()), svg_plot("plot", panels())); }

constexpr PanelStyle kStyles[] = {PanelStyle::curves, PanelStyle::marked, PanelStyle::cloud, PanelStyle::steps,
                                  PanelStyle::plane};

bool is_linear(PanelStyle style) { return style == PanelStyle::curves || style == PanelStyle::plane; }

// Each list of series in a panel of its own.
std::vector<Panel> panels_of(const std::vector<std::vector<Series>>& each, PanelStyle style) {
  std::vector<Panel> panels;
  for (const std::vector<Series>& series : each) panels.push_back({"panel", "", "", series, style, "no robot"});
  return panels;
}

std::size_t count(const std::string& svg, const std::string& text) {
  std::size_t found = 0;
  for (std::size_t at = svg.find(text); at != std::string::npos; at = svg.find(text, at + 1)) ++found;
  return found;
}

TEST(Plot, SaysWhereThereIsNothingToPlot) {
  const std::vector<std::vector<Series>> nowhere = {
      {}, {{"a", {}, {}}}, {{"a", {1, 2}, {NAN, INFINITY}}}, {{"a", {NAN}, {1}}}, {{"a", {1, 2}, {1e308, -1e308}}}};
  const std::vector<std::vector<Series>> not_above_zero = {
      {{"a", {0}, {0}}}, {{"a", {0, 0}, {1, 2}}}, {{"a", {-1}, {0}}, {"b", {-2, -3}, {0, 0}}}};
  for (const PanelStyle style : kStyles) {
    EXPECT_EQ(count(svg_plot("plot", panels_of(nowhere, style)), "nothing to plot: no robot"), nowhere.size());
    EXPECT_EQ(count(svg_plot("plot", panels_of(not_above_zero, style)), "nothing to plot: no robot"),
              is_linear(style) ? 0 : not_above_zero.size());
  }
  EXPECT_THAT(svg_plot("no panels", {}), HasSubstr("nothing to plot"));
}

// Data for which gnuplot would choose no range, or one without marks.
TEST(Plot, DrawsOnePointAndConstants) {
  const std::vector<std::vector<Series>> hard = {{{"point", {1}, {5}}},
                                                 {{"constant", {1, 2, 3}, {5, 5, 5}}},
                                                 {{"above each other", {2, 2}, {1, 3}}},
                                                 {{"denormal", {1, 2}, {1e-320, 2e-320}}},
                                                 {{"almost constant", {1, 2}, {1e20, 1e20 + 20000}}},
                                                 {{"almost one time", {1e9, 1e9 + 1e-6}, {1, 2}}}};
  for (const PanelStyle style : kStyles) {
    const std::string svg = svg_plot("plot", panels_of(hard, style));
    for (const auto& series : hard) EXPECT_THAT(svg, HasSubstr(series.front().name));
    EXPECT_THAT(svg, Not(HasSubstr("nothing to plot")));
  }
}

TEST(Plot, NamesTheSeriesThatHasNoPlace) {
  const std::string svg =
      svg_plot("plot", {{"panel", "", "", {{"zero", {1, 2}, {0, 0}}, {"some", {1, 2}, {0, 1}}}, PanelStyle::cloud}});
  EXPECT_THAT(svg, HasSubstr("zero: nothing to plot"));
  EXPECT_THAT(svg, Not(HasSubstr("some: nothing to plot")));
}

TEST(SvgPlot, SaysWhatToInstallWithoutGnuplot) {
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", "/nowhere", 1);
  try {
    svg_plot("plot", panels());
    ADD_FAILURE() << "drawn without gnuplot";
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.kind(), FailureKind::io);
    EXPECT_THAT(failure.hint(), HasSubstr("gnuplot-nox"));
  }
  ::setenv("PATH", path.c_str(), 1);
}

}  // namespace
}  // namespace flatdyn::testing
