// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/plot/time_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace flatdyn {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

TEST(TimeTable, AsCsvComesBackExactly) {
  const TimeTable table{{"t", "q1"}, {{0, -0.0}, {0.1, 1.0 / 3}}};
  EXPECT_EQ(csv_text(table), "t,q1\n0,0\n0.1,0.3333333333333333\n");
}

// A peak of one sample among a hundred thousand must be visible.
TEST(TimePlot, OfALongTableKeepsItsExtremes) {
  TimeTable table{{"t", "q1"}, {}};
  for (int k = 0; k < 100000; ++k) table.rows.push_back({k * 1e-3, k == 54321 ? 1000.0 : 0.0});
  const std::string svg = time_plot("plot", table, {{"position", "q in rad", {1}, {"joint 1"}}}, PictureFormat::svg);
  EXPECT_THAT(svg, HasSubstr("joint 1"));
  EXPECT_THAT(svg, HasSubstr("t in s"));
  EXPECT_THAT(svg, HasSubstr(" 1000<"));
  EXPECT_LT(svg.size(), 200000u);
}

TEST(TimePlot, IsOnWhiteAsPngAndOnNothingAsSvg) {
  const TimeTable table{{"t", "q1"}, {{0, 0}, {1, 2}}};
  const std::vector<PanelColumns> panels = {{"position", "q in rad", {1}, {"joint 1"}}};
  EXPECT_THAT(time_plot("plot", table, panels, PictureFormat::png), StartsWith("\x89PNG"));
  EXPECT_THAT(time_plot("plot", table, panels, PictureFormat::svg), Not(HasSubstr("#ffffff")));
  EXPECT_EQ(picture_format("a/b.png"), PictureFormat::png);
  EXPECT_EQ(picture_format("a/b.svg"), PictureFormat::svg);
}

}  // namespace
}  // namespace flatdyn
