// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/plot/scatter_plot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tinyxml2.h>

#include <cmath>

namespace flatdyn::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::vector<ScatterPanel> points() {
  return {{"it's <1>", "ns", "error", {{"fast_one", 10, 1e8, 1, false, true}, {"exact", 20, 0.5, 0, true, false}}},
          {"second", "ns", "", {{"nothing lost", 3, 0, 2}, {"not a number", 4, NAN, 2}, {"infinite", 5, INFINITY, 2}}}};
}

TEST(SvgScatter, ShowsAllNamesThatHaveAPlace) {
  const std::string svg = svg_scatter("time & error", points());
  for (const char* text : {"time &amp; error", "it's &lt;1", "fast_one", "exact", "nothing lost", "second"}) {
    EXPECT_THAT(svg, HasSubstr(text));
  }
  for (const char* text : {"not a number", "infinite"}) EXPECT_THAT(svg, Not(HasSubstr(text)));
}

TEST(SvgScatter, MarksZeroOnlyWhereThereIsOne) {
  const std::vector<ScatterPanel> panels = points();
  EXPECT_THAT(svg_scatter("plot", {panels[1]}), HasSubstr("exact</tspan>"));
  ScatterPanel without = panels[1];
  without.points[0].y = 1;
  EXPECT_THAT(svg_scatter("plot", {without}), Not(HasSubstr("exact")));
}

TEST(SvgScatter, IsWellFormed) {
  tinyxml2::XMLDocument document;
  EXPECT_EQ(document.Parse(svg_scatter("plot", points()).c_str()), tinyxml2::XML_SUCCESS);
  EXPECT_STREQ(document.RootElement()->Name(), "svg");
}

TEST(SvgScatter, GivesTheSameBytesInEveryRun) {
  EXPECT_EQ(svg_scatter("plot", points()), svg_scatter("plot", points()));
}

TEST(SvgScatter, SaysWhereThereIsNothingToPlot) {
  const std::vector<std::vector<ScatterPoint>> nowhere = {
      {}, {{"a", 0, 1}}, {{"a", NAN, 1}}, {{"a", INFINITY, 1}}, {{"a", 1, NAN}}, {{"a", 1, -1}}, {{"a", 1, 1e308}}};
  for (const auto& scattered : nowhere) {
    EXPECT_THAT(svg_scatter("plot", {{"panel", "ns", "", scattered}}), HasSubstr("nothing to plot"));
  }
  EXPECT_THAT(svg_scatter("plot", {}), HasSubstr("nothing to plot"));
}

TEST(SvgScatter, DrawsOnePointAndWhatIsExact) {
  const std::vector<std::vector<ScatterPoint>> hard = {
      {{"a", 1, 1}}, {{"a", 1, 0}}, {{"a", 1, 0}, {"b", 2, 0}}, {{"a", 1, 1}, {"b", 1, 1}}};
  for (const auto& scattered : hard) {
    EXPECT_THAT(svg_scatter("plot", {{"panel", "ns", "", scattered}}), Not(HasSubstr("nothing to plot")));
  }
}

}  // namespace
}  // namespace flatdyn::testing
