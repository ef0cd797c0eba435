// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/states.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "truth/reference/reference_model.hpp"

namespace flatdyn {
namespace {

Mechanism three_joints() {
  Mechanism mechanism;
  mechanism.bodies.resize(3);
  mechanism.bodies[0].limits.lower = Value{GiNaC::numeric(-1, 4), {}};
  mechanism.bodies[0].limits.upper = Value{GiNaC::numeric(1, 2), {}};
  mechanism.bodies[0].limits.velocity = Value{GiNaC::numeric(3), {}};
  mechanism.bodies[1].prismatic = true;
  mechanism.bodies[2].limits.velocity = Value{GiNaC::numeric(0), {}};
  return mechanism;
}

TEST(States, StayWithinTheLimitsAndFillThem) {
  double lowest = 0, highest = 0, fastest = 0, slid = 0, unlimited = 0;
  for (const State& state : random_states(three_joints(), 2000, 7)) {
    lowest = std::min(lowest, state.q[0]);
    highest = std::max(highest, state.q[0]);
    fastest = std::max(fastest, std::abs(state.qd[0]));
    slid = std::max(slid, std::abs(state.q[1]));
    unlimited = std::max(unlimited, std::abs(state.qd[2]));
  }
  EXPECT_GE(lowest, -0.25);
  EXPECT_LE(lowest, -0.24);
  EXPECT_LE(highest, 0.5);
  EXPECT_GE(highest, 0.49);
  EXPECT_LE(fastest, 3);
  EXPECT_GE(fastest, 2.9);
  EXPECT_LE(slid, 1);
  EXPECT_GE(slid, 0.99);
  EXPECT_GE(unlimited, 4.9) << "a velocity limit of 0 says nothing";
}

// These numbers depend only on std::mt19937_64, which the standard defines.
TEST(States, AreTheSameOnEveryMachine) {
  std::mt19937_64 engine(7);
  const double first = -0.25 + 0.75 * (static_cast<double>(engine() >> 11) / 9007199254740992.0);
  const std::vector<State> states = random_states(three_joints(), 2, 7);
  EXPECT_EQ(states[0].q[0], first);
  EXPECT_EQ(states[1].tau, random_states(three_joints(), 2, 7)[1].tau);
  EXPECT_NE(states[0].q, random_states(three_joints(), 1, 8)[0].q);
}

TEST(States, AtTheEdges) {
  const std::vector<State> states = edge_states(three_joints());
  const auto has = [&](double q, double qd) {
    return std::any_of(states.begin(), states.end(), [&](const State& s) { return s.q[2] == q && s.qd[2] == qd; });
  };
  for (const double q : {0.0, 1.5707963267948966, -1.5707963267948966, 3.141592653589793, -3.141592653589793}) {
    EXPECT_TRUE(has(q, 0)) << q;
    EXPECT_TRUE(has(q, -1000)) << q;
  }
  EXPECT_TRUE(std::any_of(states.begin(), states.end(), [](const State& s) { return s.q[0] > 1000; }));
}

TEST(States, AreWidenedExactly) {
  const State state = random_states(three_joints(), 1, 3)[0];
  EXPECT_EQ(widened<Real50>(state).of(InputKind::tau)[1], Real50(state.tau[1]));
}

}  // namespace
}  // namespace flatdyn
