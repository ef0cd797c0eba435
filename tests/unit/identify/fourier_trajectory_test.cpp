// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/fourier_trajectory.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace flatdyn::testing {
namespace {

constexpr double kDuration = 7;

FourierTrajectory some_trajectory() {
  return {kDuration, {0.5, -2}, {{{0.3, -1.1, 0.7}, {0.9, 0.2, -0.4}}, {{-0.8, 0.1, 0.6}, {0.05, -0.7, 1.2}}}};
}

TEST(FourierTrajectory, StartsAndEndsAtRest) {
  const FourierTrajectory trajectory = some_trajectory();
  constexpr double kRounding = 1e-14;
  for (const double t : {0.0, kDuration}) {
    const FourierMotion motion = trajectory.at(t);
    EXPECT_NEAR(motion.q[0], 0.5, kRounding);
    EXPECT_NEAR(motion.q[1], -2, kRounding);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_NEAR(motion.qd[i], 0, kRounding) << t;
      EXPECT_NEAR(motion.qdd[i], 0, kRounding) << t;
    }
  }
  EXPECT_GT(std::abs(trajectory.at(1).q[0] - 0.5), 0.05);
}

TEST(FourierTrajectory, SpeedAndAccelerationAreTheDerivatives) {
  const FourierTrajectory trajectory = some_trajectory();
  constexpr double kStep = 1e-5, kTolerance = 1e-8;
  for (double t = 0.3; t < kDuration; t += 0.37) {
    const FourierMotion before = trajectory.at(t - kStep), now = trajectory.at(t), after = trajectory.at(t + kStep);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_NEAR(now.qd[i], (after.q[i] - before.q[i]) / (2 * kStep), kTolerance) << t;
      EXPECT_NEAR(now.qdd[i], (after.qd[i] - before.qd[i]) / (2 * kStep), kTolerance) << t;
    }
  }
}

// Without the Fourier series a polynomial of degree five remains: its sixth differences vanish.
TEST(FourierTrajectory, IsAFourierSeriesPlusAQuintic) {
  const double frequency = 2 * 3.141592653589793 / kDuration, a = 0.8, b = -1.3;
  const FourierTrajectory trajectory(kDuration, {0}, {{{0, a}, {0, b}}});
  const auto rest = [&](int k) {
    const double t = 0.4 + 0.9 * k, angle = 2 * frequency * t;
    return trajectory.at(t).q[0] - a / (2 * frequency) * std::sin(angle) + b / (2 * frequency) * std::cos(angle);
  };
  const double sixth = rest(0) - 6 * rest(1) + 15 * rest(2) - 20 * rest(3) + 15 * rest(4) - 6 * rest(5) + rest(6);
  EXPECT_NEAR(sixth, 0, 1e-12);
  EXPECT_GT(std::abs(rest(0) - 3 * rest(1) + 3 * rest(2) - rest(3)), 1e-3);
}

TEST(FourierTrajectory, ScalesTheDeflectionFromRest) {
  const FourierTrajectory trajectory = some_trajectory();
  const FourierMotion whole = trajectory.at(2.5), half = trajectory.scaled({0.5, 2}).at(2.5);
  EXPECT_NEAR(half.q[0] - 0.5, 0.5 * (whole.q[0] - 0.5), 1e-14);
  EXPECT_NEAR(half.qdd[1], 2 * whole.qdd[1], 1e-13);
}

TEST(FourierTrajectory, SamplesBothEnds) {
  const std::vector<FourierMotion> samples = sampled(some_trajectory(), 10);
  ASSERT_EQ(samples.size(), 11u);
  EXPECT_EQ(samples[5].q, some_trajectory().at(kDuration / 2).q);
  EXPECT_NEAR(samples.back().q[1], -2, 1e-14);
}

}  // namespace
}  // namespace flatdyn::testing
