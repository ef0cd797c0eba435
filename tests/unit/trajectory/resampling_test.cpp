// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/trajectory/resampling.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace flatdyn {
namespace {

// A motion and a force, sampled at uneven times from 1 s to 3 s.
Trajectory uneven_sine() {
  Trajectory trajectory;
  for (int k = 0; k <= 200; ++k) {
    const double t = 1 + 2 * std::pow(k / 200.0, 1.2);
    trajectory.points.push_back({t, {std::sin(2 * t)}, {2 * std::cos(2 * t)}, {-4 * std::sin(2 * t)}, {3 * t}});
  }
  return trajectory;
}

TEST(Resampling, IsEvenAndKeepsBothEnds) {
  const Trajectory given = uneven_sine(), even = resampled(given, 50);
  ASSERT_EQ(even.points.size(), 51U);
  for (std::size_t k = 0; k <= 50; ++k) EXPECT_NEAR(even.points[k].time, 1 + 0.04 * static_cast<double>(k), 1e-15);
  for (const auto& [a, b] :
       {std::pair{given.points.front(), even.points.front()}, std::pair{given.points.back(), even.points.back()}}) {
    EXPECT_EQ(a.time, b.time);
    EXPECT_EQ(a.q, b.q);
    EXPECT_EQ(a.qd, b.qd);
    EXPECT_EQ(a.qdd, b.qdd);
    EXPECT_EQ(a.h_e, b.h_e);
  }
}

TEST(Resampling, GivesTheMotionAndItsDerivatives) {
  for (const TrajectoryPoint& point : resampled(uneven_sine(), 333).points) {
    EXPECT_NEAR(point.q[0], std::sin(2 * point.time), 1e-12);
    EXPECT_NEAR(point.qd[0], 2 * std::cos(2 * point.time), 1e-10);
    EXPECT_NEAR(point.qdd[0], -4 * std::sin(2 * point.time), 1e-7);
    EXPECT_NEAR(point.h_e[0], 3 * point.time, 1e-13);
  }
}

// Acceleration 2, then -2: the samples before and after the jump have one of them each.
TEST(Resampling, KeepsJumpsOfTheAcceleration) {
  const Trajectory jump{{{0, {0}, {0}, {2}, {}}, {1, {1}, {2}, {-2}, {}, {2}}, {2, {2}, {0}, {-2}, {}}}};
  const Trajectory even = resampled(jump, 8);
  ASSERT_EQ(even.points.size(), 9U);
  for (std::size_t k = 0; k <= 8; ++k) {
    EXPECT_NEAR(even.points[k].qdd[0], k < 4 ? 2 : -2, 1e-13) << k;
    EXPECT_TRUE(even.points[k].qdd_before.empty());
  }
  EXPECT_NEAR(even.points[3].q[0], 0.5625, 1e-15);
}

TEST(Resampling, OfOneIntervalIsBothEnds) { EXPECT_EQ(resampled(uneven_sine(), 1).points.size(), 2U); }

}  // namespace
}  // namespace flatdyn
