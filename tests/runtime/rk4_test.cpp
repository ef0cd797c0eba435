// SPDX-License-Identifier: GPL-2.0-or-later
#include "flatdyn/rk4.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "laboratory/simulate/simulator.hpp"
#include "panda.hpp"
#include "support/robot_models.hpp"

namespace flatdyn {
namespace {

// q̈ = −q from (1, 0): q = cos t.
double error_after_one_second(int steps) {
  double q[1] = {1}, qd[1] = {0};
  const auto spring = [](const double* x, const double*, double* a) {
    a[0] = -x[0];
    return true;
  };
  for (int k = 0; k < steps; ++k) EXPECT_TRUE(rk4_step<1>(q, qd, 1.0 / steps, spring));
  return std::hypot(q[0] - std::cos(1.0), qd[0] + std::sin(1.0));
}

TEST(Rk4, IsOfOrderFour) {
  const double coarse = error_after_one_second(20), fine = error_after_one_second(40);
  EXPECT_LT(coarse, 1e-7);
  EXPECT_NEAR(coarse / fine, 16, 0.5);
}

TEST(Rk4, LeavesTheStateWhereAccelerationsAreRefused) {
  float q[2] = {1, 2}, qd[2] = {3, 4};
  int calls = 0;
  const auto refusing = [&calls](const float*, const float*, float* a) {
    a[0] = a[1] = 1;
    return ++calls < 3;
  };
  EXPECT_FALSE(rk4_step<2>(q, qd, 0.1f, refusing));
  EXPECT_EQ(q[0], 1);
  EXPECT_EQ(qd[1], 4);
}

// The generated Panda falls like the simulation of the same robot.
TEST(Rk4, StepsAsTheSimulationDoes) {
  const LoadedRobot model = testing::model_of("panda.urdf");
  Simulation simulation = resting(model.robot, model.mechanism);
  simulation.duration = 0.5;
  simulation.rate = 100;
  simulation.method = IntegrationMethod::rk4;
  Progress quiet(true);
  JointDynamics dynamics(model, quiet);
  const SimulatedMotion motion = simulate(simulation, dynamics, [](double) { return false; });
  double q[7] = {}, qd[7] = {};
  const double tau[7] = {};
  const auto arm = [&tau](const double* at, const double* rate, double* qdd) {
    return panda::forward_dynamics(at, rate, tau, qdd);
  };
  for (int k = 0; k < 500; ++k) ASSERT_TRUE(rk4_step<7>(q, qd, 1e-3, arm));
  for (int i = 0; i < 7; ++i) {
    EXPECT_NEAR(q[i], motion.rows.back().q(i), 1e-11);
    EXPECT_NEAR(qd[i], motion.rows.back().qd(i), 1e-10);
  }
}

}  // namespace
}  // namespace flatdyn
