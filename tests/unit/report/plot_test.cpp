// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/plot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "diagnostics/diagnostics.hpp"

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

TEST(SvgPlot, SaysWhatToInstallWithoutGnuplot) {
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", "/nowhere", 1);
  try {
    svg_plot("plot", panels());
    ADD_FAILURE() << "drawn without gnuplot";
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.code(), ExitCode::io);
    EXPECT_THAT(failure.hint(), HasSubstr("gnuplot-nox"));
  }
  ::setenv("PATH", path.c_str(), 1);
}

}  // namespace
}  // namespace flatdyn::testing
