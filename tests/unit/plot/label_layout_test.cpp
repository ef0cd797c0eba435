// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/plot/label_layout.hpp"

#include <gtest/gtest.h>

#include <random>

namespace flatdyn::testing {
namespace {

constexpr Box kFrame{0, 0, 800, 400};

// The pole from a point to its flag.
Box pole(const LabelledPoint& point, const Box& flag) {
  const double middle = (flag.top + flag.bottom) / 2;
  return {point.x, std::min(point.y, middle), point.x + 0.05, std::max(point.y, middle)};
}

void expect_readable(const std::vector<LabelledPoint>& points) {
  const std::vector<Box> flags = placed_labels(points, kFrame);
  ASSERT_EQ(flags.size(), points.size());
  for (std::size_t a = 0; a < flags.size(); ++a) {
    EXPECT_EQ(flags[a].left, points[a].x);
    for (std::size_t b = 0; b < flags.size(); ++b) {
      if (a == b) continue;
      EXPECT_FALSE(flags[a].overlaps(flags[b])) << points[a].text << " and " << points[b].text;
      EXPECT_FALSE(flags[a].overlaps(pole(points[b], flags[b]))) << points[a].text << " and " << points[b].text;
    }
  }
}

TEST(PlacedLabels, OneStandsAboveItsPoint) {
  const std::vector<Box> flags = placed_labels({{100, 300, "double"}}, kFrame);
  EXPECT_LT(flags[0].bottom, 300);
  EXPECT_GT(flags[0].bottom, 280);
}

TEST(PlacedLabels, OnesInTheUpperHalfStandAboveAllPoints) {
  for (const Box& flag : placed_labels({{100, 20, "float"}, {300, 120, "MuJoCo"}}, kFrame)) EXPECT_LT(flag.bottom, 20);
}

TEST(PlacedLabels, NeitherNamesNorPolesCrossNames) {
  std::mt19937 engine(1);
  const auto below = [&engine](unsigned bound) { return static_cast<int>(engine() % bound); };
  for (int run = 0; run < 200; ++run) {
    std::vector<LabelledPoint> points;
    for (int k = 0; k < 24; ++k) {
      const int band = k % 2 == 0 ? 330 : 20;  // two bands, like those of double and float
      const auto length = static_cast<std::size_t>(3 + below(18));
      points.push_back({100 + below(600) + 0.04 * k, static_cast<double>(band + below(10)), std::string(length, 'x')});
    }
    expect_readable(points);
  }
}

}  // namespace
}  // namespace flatdyn::testing
