// SPDX-License-Identifier: GPL-2.0-or-later
// Infinities and NaN in the inputs of generated code reach the outputs that depend on them and no others; nothing
// traps, for one state or over lanes.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "flatdyn/batch.hpp"
#include "flatdyn/trigonometry.hpp"
#include "panda.hpp"

namespace flatdyn::testing {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Numbers {
  std::vector<double> q = {0.1, -0.4, 0.7, -1.5, 0.3, 1.1, -0.2}, qd = {0.3, 0.2, -0.1, 0.5, 0.2, -0.3, 0.1},
                      qdd = {1, -1, 0.5, 2, -0.5, 1, 0.3};
};

template <class... SinCos>
std::vector<double> torques(const Numbers& x, const SinCos&... sin_cos) {
  std::vector<double> tau(7);
  panda::inverse_dynamics(x.q.data(), x.qd.data(), x.qdd.data(), tau.data(), sin_cos...);
  return tau;
}

class NotANumber : public ::testing::TestWithParam<double> {};

TEST_P(NotANumber, ReachesEveryTorqueFromTheFirstAcceleration) {
  Numbers x;
  x.qdd[0] = GetParam();
  for (const double tau : torques(x)) EXPECT_FALSE(std::isfinite(tau));
}

TEST_P(NotANumber, ReachesWhatThePositionTurns) {
  for (std::size_t i = 1; i < 7; ++i) {
    Numbers x;
    x.q[i] = GetParam();
    const std::vector<double> single = torques(x), together = torques(x, flatdyn::TogetherSinCos());
    for (std::size_t k = 0; k < 7; ++k) {
      EXPECT_TRUE(std::isnan(single[k])) << i << " to " << k;
      EXPECT_TRUE(std::isnan(together[k])) << i << " to " << k;
    }
  }
}

// The Panda's base stands upright, so gravity does not depend on the first position.
TEST_P(NotANumber, DoesNotReachWhatDoesNotDependOnIt) {
  Numbers x;
  const std::vector<double> before = torques(x);
  x.q[0] = GetParam();
  EXPECT_EQ(torques(x), before);
  double g[7], g_before[7];
  panda::gravity(Numbers().q.data(), g_before);
  x = Numbers();
  x.q[6] = GetParam();
  panda::gravity(x.q.data(), g);
  EXPECT_EQ(g[0], g_before[0]);
  for (std::size_t k = 1; k < 7; ++k) EXPECT_TRUE(std::isnan(g[k]));
}

TEST_P(NotANumber, MakesForwardDynamicsReturnFalse) {
  Numbers x;
  x.q[3] = GetParam();
  double qdd[7];
  EXPECT_FALSE(panda::forward_dynamics(x.q.data(), x.qd.data(), x.qdd.data(), qdd));
}

TEST_P(NotANumber, StaysInItsLane) {
  constexpr std::size_t kStates = 9;
  std::vector<double> q(7 * kStates), qd(7 * kStates), qdd(7 * kStates), tau(7 * kStates);
  const Numbers x;
  for (std::size_t i = 0; i < 7; ++i) {
    for (std::size_t k = 0; k < kStates; ++k) {
      q[i * kStates + k] = x.q[i];
      qd[i * kStates + k] = x.qd[i];
      qdd[i * kStates + k] = x.qdd[i];
    }
  }
  q[2 * kStates + 5] = GetParam();
  flatdyn::for_each_state<double>(
      kStates, [](auto... of) { panda::inverse_dynamics(of...); }, flatdyn::in<7>(q.data(), kStates),
      flatdyn::in<7>(qd.data(), kStates), flatdyn::in<7>(qdd.data(), kStates), flatdyn::out<7>(tau.data(), kStates));
  for (std::size_t i = 0; i < 7; ++i) {
    for (std::size_t k = 0; k < kStates; ++k) EXPECT_EQ(std::isnan(tau[i * kStates + k]), k == 5) << i << " " << k;
  }
}

INSTANTIATE_TEST_SUITE_P(Values, NotANumber, ::testing::Values(kNaN, kInfinity, -kInfinity));

}  // namespace
}  // namespace flatdyn::testing
