// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/trajectory/interpolation.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace flatdyn {
namespace {

// Samples of q = sin t.
Trajectory sine(double step, int count) {
  Trajectory trajectory;
  for (int k = 0; k < count; ++k) {
    const double t = 2 + k * step, phase = k * step;
    trajectory.points.push_back({t, {std::sin(phase)}, {std::cos(phase)}, {-std::sin(phase)}, {}});
  }
  return trajectory;
}

double error_between(double step) {
  const Trajectory trajectory = sine(step, 21);
  double largest = 0;
  for (int k = 0; k < 200; ++k) {
    const double phase = 20 * step * k / 200;
    const TrajectoryPoint point = interpolated(trajectory, 2 + phase);
    largest = std::max({largest, std::abs(point.q[0] - std::sin(phase))});
  }
  return largest;
}

TEST(Interpolation, IsOfOrderSix) {
  EXPECT_LT(error_between(0.1), 1e-10);
  EXPECT_NEAR(error_between(0.2) / error_between(0.1), 64, 8);
}

TEST(Interpolation, MeetsTheSamplesAndStandsOutside) {
  const Trajectory trajectory = sine(0.5, 3);
  const TrajectoryPoint middle = interpolated(trajectory, 2.5);
  EXPECT_DOUBLE_EQ(middle.q[0], std::sin(0.5));
  EXPECT_DOUBLE_EQ(middle.qd[0], std::cos(0.5));
  EXPECT_DOUBLE_EQ(middle.qdd[0], -std::sin(0.5));
  for (const double outside : {1.0, 3.0, 7.0}) {
    const TrajectoryPoint point = interpolated(trajectory, outside);
    EXPECT_EQ(point.q[0], outside < 2 ? 0 : std::sin(1.0));
    EXPECT_EQ(point.qd[0], 0);
  }
}

// A motion with triangular velocity has jumps of acceleration; between them it is exactly a parabola.
TEST(Interpolation, KnowsBothSidesOfAJump) {
  Trajectory trajectory;
  trajectory.points = {{0, {0}, {0}, {2}, {}}, {1, {1}, {2}, {-2}, {}, {2}}, {2, {2}, {0}, {0}, {}, {-2}}};
  EXPECT_NEAR(interpolated(trajectory, 0.5).q[0], 0.25, 1e-15);
  EXPECT_NEAR(interpolated(trajectory, 0.5).qdd[0], 2, 1e-13);
  EXPECT_NEAR(interpolated(trajectory, 1.5).q[0], 1.75, 1e-15);
  EXPECT_NEAR(interpolated(trajectory, 1.5).qdd[0], -2, 1e-13);
}

}  // namespace
}  // namespace flatdyn
