// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/stress/worst_state.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "functions/deviation/extreme_states.hpp"
#include "support/robot_models.hpp"

namespace flatdyn::testing {
namespace {

double far_from(const State& state) { return -std::abs(state.q[0] - 0.3) - std::abs(state.qd[1] + 0.2); }

TEST(WorstState, IsFoundBetterThanBySampling) {
  const Mechanism mechanism = model_of("planar_2r.toml").mechanism;
  const std::vector<State> pool = random_states(mechanism, 50, 1);
  double sampled = -1e300;
  for (const State& state : pool) sampled = std::max(sampled, far_from(state));
  const SearchedState found = worst_state(far_from, pool, 3000, 1);
  EXPECT_EQ(found.error, far_from(found.state));
  EXPECT_GT(found.error, sampled / 10);
}

TEST(WorstState, IsTheSameForTheSameSeedAndStaysWithinTheLimits) {
  const Mechanism mechanism = model_of("panda.urdf").mechanism;
  const std::vector<State> pool = random_states(mechanism, 30, 2);
  const auto speed = [](const State& state) { return state.qd[0] + state.q[3]; };
  const SearchedState a = worst_state(speed, pool, 500, 7), b = worst_state(speed, pool, 500, 7);
  EXPECT_EQ(a.state.q, b.state.q);
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_LE(std::abs(a.state.qd[i]), nearest_double(mechanism.bodies[i].limits.velocity->number));
  }
}

TEST(ExtremeStates, HaveZeroDenormalAndLargeNumbers) {
  const Mechanism mechanism = model_of("panda.urdf").mechanism;
  const std::vector<State> states = extreme_states(mechanism, 100, 1);
  ASSERT_EQ(states.size(), 100u);
  EXPECT_EQ(states[0].qd, std::vector<double>(7, 0));
  EXPECT_EQ(states[1].qd, std::vector<double>(7, 5e-324));
  EXPECT_EQ(states[2].q, std::vector<double>(7, 1e8));
  bool has_large = false, has_denormal = false;
  for (std::size_t k = 3; k < states.size(); ++k) {
    for (const double rate : states[k].qd) {
      has_large = has_large || rate == -1e6;
      has_denormal = has_denormal || rate == -1e-310;
    }
  }
  EXPECT_TRUE(has_large && has_denormal);
}

}  // namespace
}  // namespace flatdyn::testing
