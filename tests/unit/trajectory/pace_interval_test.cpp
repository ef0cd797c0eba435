// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/trajectory/pace_interval.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace flatdyn {
namespace {

struct Row {
  double alpha, beta, gamma;
};

// The interval of x by trying every vertex: intersections of two rows, and rows without u.
std::optional<Interval> by_vertices(const std::vector<Row>& rows) {
  std::optional<Interval> found;
  const auto try_point = [&](double u, double x) {
    if (!std::isfinite(u) || !std::isfinite(x)) return;
    for (const Row& row : rows) {
      const double size = std::abs(row.alpha * u) + std::abs(row.beta * x) + std::abs(row.gamma) + 1;
      if (row.alpha * u + row.beta * x > row.gamma + 1e-9 * size) return;
    }
    if (!found) found = Interval{x, x};
    found->least = std::min(found->least, x);
    found->greatest = std::max(found->greatest, x);
  };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Row &a = rows[i], &b = rows[j];
      const double det = a.alpha * b.beta - b.alpha * a.beta;
      try_point((a.gamma * b.beta - b.gamma * a.beta) / det, (a.alpha * b.gamma - b.alpha * a.gamma) / det);
    }
  }
  return found;
}

// Random rows, bounded by x ≤ 50: about as many have a solution as have none.
TEST(PaceRows, FindTheIntervalThatAllVerticesGive) {
  std::mt19937 engine(11);
  std::uniform_real_distribution<double> factor(-1, 1), room(-0.3, 1);
  const double delta = 0.1;
  int found = 0, empty = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Interval next{0.5, 4};
    std::vector<Row> all = {{0, 1, 50}, {0, -1, 0}, {2 * delta, 1, next.greatest}, {-2 * delta, -1, -next.least}};
    PaceRows rows;
    rows.add(0, 1, 50);
    for (int k = 0; k < 6; ++k) {
      const Row row{k == 5 ? 0 : factor(engine), factor(engine), room(engine)};
      rows.add(row.alpha, row.beta, row.gamma);
      all.push_back(row);
    }
    const std::optional<Interval> expected = by_vertices(all), interval = rows.reachable(delta, next);
    // Sets as thin as rounding may count either way.
    if (expected && expected->greatest - expected->least < 1e-6) continue;
    ASSERT_EQ(interval.has_value(), expected.has_value()) << trial;
    (expected ? found : empty) += 1;
    if (!expected) continue;
    EXPECT_NEAR(interval->least, expected->least, 1e-7) << trial;
    EXPECT_NEAR(interval->greatest, expected->greatest, 1e-7) << trial;
    const double x = (interval->least + interval->greatest) / 2, u = rows.largest_u(x, delta, next);
    for (const Row& row : all) EXPECT_LE(row.alpha * u + row.beta * x, row.gamma + 1e-9) << trial;
  }
  EXPECT_GT(found, 300);
  EXPECT_GT(empty, 300);
}

TEST(PaceRows, AreRefusedByARowWithoutVariables) {
  PaceRows rows;
  rows.add(0, 0, -1);
  EXPECT_FALSE(rows.reachable(0.1, {0, 1}));
  rows.clear();
  rows.add(0, 0, 1);
  EXPECT_TRUE(rows.reachable(0.1, {0, 1}));
}

}  // namespace
}  // namespace flatdyn
