// SPDX-License-Identifier: GPL-2.0-or-later
// Simulated motion against motions known in closed form.
#include "laboratory/simulate/simulator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/special_functions/ellint_1.hpp>
#include <cmath>
#include <numbers>

#include "flatdyn/reference/newton_euler.hpp"
#include "support/robot_models.hpp"
#include "support/written_model.hpp"
#include "truth/reference/reference_model.hpp"

namespace flatdyn {
namespace {

using testing::model_of;
using testing::model_of_toml;

// A body of 2 kg that slides along z, which is horizontal.
LoadedRobot block(const std::string& friction) {
  return model_of_toml(
      "name = \"block\"\ngravity = [0, \"-9.81\", 0]\ndh = \"standard\"\n[[link]]\njoint = \"rail\"\n"
      "type = \"prismatic\"\nmass = 2\nlimits = { lower = -1, upper = 1 }\n" +
      friction);
}

LoadedRobot pendulum() {
  return model_of_toml(
      "name = \"pendulum\"\ngravity = [0, \"-9.81\", 0]\ndh = \"standard\"\n[[link]]\njoint = \"hinge\"\na = 1\n"
      "mass = 1\n");
}

SimulatedMotion run(const LoadedRobot& model, Simulation simulation) {
  Progress progress(true);
  JointDynamics dynamics(model, progress);
  return simulate(simulation, dynamics, [](double) { return false; });
}

const SimulationRow& at(const SimulatedMotion& motion, double time) {
  return *std::find_if(motion.rows.begin(), motion.rows.end(),
                       [time](const SimulationRow& row) { return row.time > time - 1e-9; });
}

class BlockTest : public ::testing::TestWithParam<IntegrationMethod> {
 protected:
  // A start with this speed: with 2 kg and F_s = 4 N it loses 2 m/s in every second.
  Simulation moving(const LoadedRobot& model, double speed, double duration) const {
    Simulation simulation = resting(model.robot, model.mechanism);
    simulation.qd = {speed};
    simulation.duration = duration;
    simulation.rate = 100;
    simulation.method = GetParam();
    return simulation;
  }
};

TEST_P(BlockTest, ComesToRestWhereItHasSpentItsEnergy) {
  const LoadedRobot model = block("coulomb = 4\n");
  const SimulatedMotion motion = run(model, moving(model, 1, 2));
  const double slack = GetParam() == IntegrationMethod::rk4 ? 1.1e-3 : 1e-9;
  ASSERT_EQ(motion.events.size(), 1U);
  EXPECT_EQ(motion.events[0].kind, EventKind::rests);
  EXPECT_NEAR(motion.events[0].time, 0.5, slack);
  EXPECT_NEAR(motion.rows.back().q(0), 0.25, slack);
  EXPECT_EQ(motion.rows.back().qd(0), 0);  // no chatter
  EXPECT_NEAR(motion.rows.back().dissipated, 1, 10 * slack);
  EXPECT_LT(energy_error(motion), 10 * slack);
}

TEST_P(BlockTest, BreaksAwayWhenTheTorqueExceedsDryFriction) {
  const LoadedRobot model = block("coulomb = 4\n");
  Simulation simulation = moving(model, 0, 2);
  simulation.samples = TorqueSamples{TorqueSamples::Between::linear, {0, 10}, {{0}, {50}}};
  const SimulatedMotion motion = run(model, simulation);
  const double slack = GetParam() == IntegrationMethod::rk4 ? 1.1e-3 : 1e-8;
  ASSERT_EQ(motion.events.size(), 1U);
  EXPECT_NEAR(motion.events[0].time, 0.8, slack);  // 5 N/s up to 4 N
  EXPECT_EQ(at(motion, 0.7).q(0), 0);
  EXPECT_NEAR(at(motion, 0.7).friction(0), -3.5, 1e-12);
  // 2 q̈ = 5 (t − 0.8)
  EXPECT_NEAR(at(motion, 1.8).q(0), 5.0 / 2 / 6, 10 * slack);
}

// 2 q̈ + 8 (q − 0.1) = 0 from rest at 0: q = 0.1 − 0.1 cos 2t.
TEST_P(BlockTest, SwingsOnItsSpring) {
  const LoadedRobot model = block("stiffness = 8\nspring_reference = 0.1\n");
  const SimulatedMotion motion = run(model, moving(model, 0, 2));
  for (const SimulationRow& row : motion.rows) EXPECT_NEAR(row.q(0), 0.1 - 0.1 * std::cos(2 * row.time), 1e-8);
  EXPECT_NEAR(motion.rows.front().potential, 0.04, 1e-12);
  EXPECT_LT(energy_error(motion), 1e-8);
}

TEST_P(BlockTest, StopsAtTheEndOfItsRange) {
  const LoadedRobot model = block("");
  Simulation simulation = moving(model, 2, 2);
  simulation.at_limits = AtLimits::stop;
  const SimulatedMotion motion = run(model, simulation);
  ASSERT_FALSE(motion.events.empty());
  EXPECT_EQ(motion.events[0].kind, EventKind::meets_upper_limit);
  EXPECT_EQ(motion.rows.back().q(0), 1);
  EXPECT_EQ(motion.rows.back().qd(0), 0);
  EXPECT_NEAR(motion.rows.back().dissipated, 4, 1e-9);
  simulation.at_limits = AtLimits::end;
  const SimulatedMotion ended = run(model, simulation);
  EXPECT_TRUE(ended.at_limit);
  EXPECT_NEAR(ended.end, 0.5, 1.1e-3);
}

TEST_P(BlockTest, IsPushedOffItsStopAgain) {
  const LoadedRobot model = block("coulomb = 1\n");
  Simulation simulation = moving(model, 0, 3);
  simulation.at_limits = AtLimits::stop;
  simulation.q = {1};
  simulation.samples = TorqueSamples{TorqueSamples::Between::hold, {0, 1}, {{8}, {-3}}};
  const SimulatedMotion motion = run(model, simulation);
  EXPECT_EQ(at(motion, 0.9).q(0), 1);
  EXPECT_NEAR(at(motion, 0.9).friction(0), -8, 1e-12);
  EXPECT_NEAR(at(motion, 2).q(0), 0.5, 2e-3);  // 2 q̈ = −3 + 1
}

INSTANTIATE_TEST_SUITE_P(Methods, BlockTest, ::testing::Values(IntegrationMethod::adaptive, IntegrationMethod::rk4),
                         [](const auto& method) {
                           return std::string(method.param == IntegrationMethod::rk4 ? "Rk4" : "Adaptive");
                         });

// The period of the mathematical pendulum is 4 K(sin(θ/2)) sqrt(l/g).
TEST(Simulator, SwingsAsLongAsAPendulumDoes) {
  const LoadedRobot model = pendulum();
  Simulation simulation = resting(model.robot, model.mechanism);
  const double amplitude = 2;  // rad from hanging
  simulation.q = {amplitude - std::numbers::pi / 2};
  const double period = 4 * boost::math::ellint_1(std::sin(amplitude / 2)) / std::sqrt(9.81);
  simulation.duration = period;
  simulation.rate = 8 / period;
  simulation.tolerance = 1e-12;
  const SimulatedMotion motion = run(model, simulation);
  ASSERT_EQ(motion.rows.size(), 9U);
  EXPECT_NEAR(motion.rows[8].q(0), simulation.q[0], 1e-9);
  EXPECT_NEAR(motion.rows[8].qd(0), 0, 1e-9);
  EXPECT_NEAR(motion.rows[4].q(0), -amplitude - std::numbers::pi / 2, 1e-9);
  EXPECT_NEAR(motion.rows[2].q(0), -std::numbers::pi / 2, 1e-9);
  EXPECT_LT(energy_error(motion), 1e-9);
}

TEST(Simulator, Rk4IsOfOrderFour) {
  const LoadedRobot model = pendulum();
  Simulation simulation = resting(model.robot, model.mechanism);
  simulation.duration = 1;
  simulation.rate = 1;
  simulation.tolerance = 1e-13;
  const double exact = run(model, simulation).rows.back().q(0);
  simulation.method = IntegrationMethod::rk4;
  double error[2] = {};
  for (int k = 0; k < 2; ++k) {
    simulation.step = k == 0 ? 0.02 : 0.01;
    error[k] = std::abs(run(model, simulation).rows.back().q(0) - exact);
  }
  EXPECT_NEAR(error[0] / error[1], 16, 1.5);
}

// Computed torque makes the error obey ë + k_D ė + k_P e = 0: with k_P = 25, k_D = 10 it is e_0 (1 + 5 t) exp(−5 t).
TEST(Simulator, ComputedTorqueMakesTheErrorLinear) {
  const LoadedRobot model = model_of("panda.urdf");
  Simulation simulation = resting(model.robot, model.mechanism);
  simulation.q = {0, -0.785, 0, -2.356, 0, 1.571, 0.785};
  simulation.duration = 1;
  simulation.rate = 10;
  simulation.tolerance = 1e-11;
  FeedbackLaw law{FeedbackLaw::Kind::computed_torque, {}, {}, {0.5, 0.2, -0.3, -1.5, 0.4, 1.8, 0}, false, {}};
  law.kp.assign(7, 25);
  law.kd.assign(7, 10);
  simulation.feedback = law;
  for (const SimulationRow& row : run(model, simulation).rows) {
    for (std::size_t i = 0; i < 7; ++i) {
      const double start = law.position[i] - simulation.q[i];
      const double error = start * (1 + 5 * row.time) * std::exp(-5 * row.time);
      EXPECT_NEAR(law.position[i] - row.q(static_cast<Eigen::Index>(i)), error, 1e-9);
    }
  }
}

// Inverse after forward dynamics, over a whole motion with dry friction: the recursive reference finds each row's
// torque from its q̈.
TEST(Simulator, EveryRowIsInverseDynamicsOfItsMotion) {
  for (const char* name : {"panda.urdf", "puma560.toml"}) {
    const LoadedRobot model = model_of(name);
    Simulation simulation = resting(model.robot, model.mechanism);
    simulation.duration = 2;
    simulation.rate = 50;
    const reference::Robot<double> arm = reference_robot<double>(model.robot, {});
    const SimulatedMotion motion = run(model, simulation);
    ASSERT_EQ(motion.rows.size(), 101U);
    for (const SimulationRow& row : motion.rows) {
      const Eigen::VectorXd rigid = reference::inverse_dynamics(arm, row.q, row.qd, row.qdd, {.friction = false});
      EXPECT_LE((rigid - row.tau - row.friction).norm(), 1e-9 * (1 + rigid.norm())) << name << " " << row.time;
    }
    EXPECT_LT(energy_error(motion), 1e-5);
  }
}

// A digital controller keeps its torque for a period.
TEST(Simulator, HoldsTheTorqueForThePeriod) {
  const LoadedRobot model = block("");
  Simulation simulation = resting(model.robot, model.mechanism);
  simulation.duration = 1;
  simulation.rate = 1000;
  simulation.feedback = FeedbackLaw{FeedbackLaw::Kind::pd, {10}, {2}, {0.5}, false, {}};
  simulation.period = 0.1;
  const SimulatedMotion motion = run(model, simulation);
  for (const SimulationRow& row : motion.rows) {
    const double measured = std::floor(row.time * 10 + 1e-6) / 10;
    if (std::abs(row.time - measured) < 1e-9) continue;  // either the old torque or the new one
    const SimulationRow& then = at(motion, measured);
    EXPECT_NEAR(row.tau(0), 10 * (0.5 - then.q(0)) - 2 * then.qd(0), 1e-9) << row.time;
  }
}

TEST(Simulator, TorquesEndAtTheEffortLimit) {
  const LoadedRobot model = model_of("panda.urdf");
  Simulation simulation = resting(model.robot, model.mechanism);
  simulation.duration = 0.01;
  simulation.constant.assign(7, 1000);
  simulation.saturate = true;
  const SimulatedMotion motion = run(model, simulation);
  EXPECT_EQ(motion.rows[0].tau(0), 87);
  EXPECT_EQ(motion.rows[0].tau(6), 12);
}

TEST(Simulator, EndsWhereItIsInterrupted) {
  const LoadedRobot model = pendulum();
  Progress progress(true);
  JointDynamics dynamics(model, progress);
  const SimulatedMotion motion =
      simulate(resting(model.robot, model.mechanism), dynamics, [](double time) { return time > 1; });
  EXPECT_TRUE(motion.interrupted);
  EXPECT_GT(motion.end, 1);
  EXPECT_LT(motion.end, 2);
  EXPECT_GE(motion.rows.size(), 1001U);
}

TEST(Simulator, SaysWhereAMotionCannotBeFollowed) {
  const LoadedRobot model = block("");
  Simulation simulation = resting(model.robot, model.mechanism);
  simulation.feedback = FeedbackLaw{FeedbackLaw::Kind::pd, {-1e30}, {-1e30}, {1}, false, {}};
  EXPECT_THROW(run(model, simulation), Failure);
}

// The number of evaluations, which does not depend on the machine's load: 10 s of the Panda under PD control.
TEST(Simulator, TakesFewEvaluations) {
  const LoadedRobot model = model_of("panda.urdf");
  Simulation simulation = resting(model.robot, model.mechanism);
  Diagnostics none;
  read_simulation(std::string(FLATDYN_SOURCE_DIR) + "/docs/examples/panda_reach.toml", model.robot, model.mechanism,
                  simulation, none);
  EXPECT_TRUE(none.all().empty());
  const SimulatedMotion motion = run(model, simulation);
  EXPECT_EQ(motion.rows.size(), 10001U);
  EXPECT_LT(motion.evaluations, 25000);
  EXPECT_NEAR(motion.rows.back().q(3), -1.5, 1e-6);
}

}  // namespace
}  // namespace flatdyn
