// SPDX-License-Identifier: GPL-2.0-or-later
// Motions of robots with closed loops, where the dependent joints follow.
#include <gtest/gtest.h>

#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <numbers>

#include "flatdyn/reference/closed_loops.hpp"
#include "flatdyn/reference/newton_euler.hpp"
#include "laboratory/simulate/simulator.hpp"
#include "laboratory/trajectory/torque_terms.hpp"
#include "support/robot_models.hpp"
#include "support/written_model.hpp"
#include "truth/reference/reference_model.hpp"

namespace flatdyn {
namespace {

using testing::model_of;

// Andrews' squeezer under its spring and its driving torque: the test set's solution after 0.03 s, by when the crank
// has turned twice and a half.
TEST(AndrewsSqueezer, MovesAsPublished) {
  const LoadedRobot model = model_of("andrews_squeezer.toml");
  const auto robot = reference_robot<double>(model.robot, {});
  Progress progress(true);
  JointDynamics dynamics(model, progress);
  const auto equation = [&](const std::vector<double>& x, std::vector<double>& dx, double) {
    const MotionTerms& terms = dynamics.at(&x[0], &x[1]);
    const std::span<const double> positions = dynamics.positions(&x[0]);
    const Eigen::VectorXd q = Eigen::Map<const Eigen::VectorXd>(positions.data(), 7);
    const Eigen::Vector3d pulled = Eigen::Vector3d(0.014, 0.072, 0) - reference::tip_pose(robot, q).p;
    const Eigen::Vector3d force = 4530 * (pulled.norm() - 0.07785) * pulled.normalized();
    const double spring = reference::jacobian(robot, q).topRows(3).col(0).dot(force);
    dx = {x[1], (0.033 + spring - terms.n[0]) / terms.B(0, 0)};
  };
  std::vector<double> x = {-0.0617138900142764496, 0};
  namespace odeint = boost::numeric::odeint;
  odeint::integrate_adaptive(odeint::make_controlled(1e-11, 1e-11, odeint::runge_kutta_dopri5<std::vector<double>>()),
                             equation, x, 0.0, 0.03, 1e-6);
  const std::span<const double> q = dynamics.positions(&x[0]);
  const double published[] = {15.81077119629904,   -15.75637105984298, 0.04082224013073101, 0.5244099658805304,
                              -0.5347301163226948, 1.048080741042263,  0.5347301163226948};
  for (std::size_t k = 0; k < 7; ++k) EXPECT_NEAR(q[k], published[k], 1e-6) << k;
}

// Every row: the loops are closed, the torques are those of the recursive reference, and energy is kept.
TEST(SliderCrank, IsSimulated) {
  const LoadedRobot model = model_of("slider_crank.toml");
  const auto robot = reference_robot<double>(model.robot, {});
  Progress progress(true);
  JointDynamics dynamics(model, progress);
  Simulation simulation = resting(model.robot, model.mechanism);
  simulation.duration = 2;
  simulation.rate = 100;
  simulation.constant = {0.2};
  const SimulatedMotion motion = simulate(simulation, dynamics, [](double) { return false; });
  ASSERT_EQ(motion.rows.size(), 201U);
  EXPECT_GT(motion.rows.back().q[0], 4 * std::numbers::pi);  // through all dead centres, twice
  for (const SimulationRow& row : motion.rows) {
    ASSERT_EQ(row.q.size(), 3);
    EXPECT_LT(reference::loop_closure(robot, row.q).norm(), 1e-13);
    EXPECT_GT(row.q[2], 0.149);  // assembled with the slider on the right
    const Eigen::VectorXd tau = reference::inverse_dynamics<double>(robot, row.q, row.qd, row.qdd);
    EXPECT_NEAR(tau[0], 0.2, 1e-9);
  }
  EXPECT_LT(energy_error(motion), 1e-6);
}

// Free flight of a body with a five-bar leg that motors move: loops stay closed, no force acts on the base, and
// momentum and energy are accounted for.
TEST(FiveBarHopper, IsSimulatedInFreeFlight) {
  const LoadedRobot model = model_of("../docs/examples/five_bar_hopper.toml");
  auto robot = reference_robot<double>(model.robot, {});
  Progress progress(true);
  JointDynamics dynamics(model, progress);
  Simulation simulation = resting(model.robot, model.mechanism);
  simulation.duration = 0.5;
  simulation.rate = 100;
  simulation.qd = {0.1, 0.05, 2, 0.3, 0.2, -0.5, 1, -2};
  simulation.constant = {0, 0, 0, 0, 0, 0, 0.02, -0.03};
  const SimulatedMotion motion = simulate(simulation, dynamics, [](double) { return false; });
  ASSERT_EQ(motion.rows.size(), 51U);
  for (const SimulationRow& row : motion.rows) {
    ASSERT_EQ(row.q.size(), 4);
    EXPECT_LT(reference::loop_closure(robot, row.q).norm(), 1e-13);
    robot.gravity = row.base->gravity;
    const Eigen::VectorXd tau = reference::inverse_dynamics<double>(robot, row.q, row.qd, row.qdd);
    EXPECT_LT((tau - Eigen::Map<const Eigen::VectorXd>(simulation.constant.data(), 8)).norm(), 1e-9);
  }
  EXPECT_LT(energy_error(motion), 1e-6);
  const Momentum error = momentum_error(motion);
  EXPECT_LT(error.linear.norm() + error.angular.norm(), 1e-6);
}

TEST(FiveBar, HasTorquesAlongATrajectory) {
  const LoadedRobot model = model_of("five_bar.toml");
  const auto robot = reference_robot<double>(model.robot, {});
  Progress progress(true);
  TorqueTerms terms(model, false, progress);
  ClosedPositions closed(model);
  Trajectory trajectory;
  for (int k = 0; k <= 20; ++k) {
    const double t = 0.05 * k;
    trajectory.points.push_back({t,
                                 {1.57 + 0.3 * std::sin(t), 1.57 - 0.2 * std::sin(2 * t)},
                                 {0.3 * std::cos(t), -0.4 * std::cos(2 * t)},
                                 {-0.3 * std::sin(t), 0.8 * std::sin(2 * t)},
                                 {}});
  }
  const TorqueHistory history = torque_history(terms, trajectory);
  EXPECT_LT(history.disagreement, 1e-12);
  for (std::size_t k = 0; k < trajectory.points.size(); ++k) {
    const TrajectoryPoint& point = trajectory.points[k];
    const std::vector<double> at(closed.of(point.q).begin(), closed.of(point.q).end());
    EXPECT_LT(at[1], 0);  // elbows outside, as assembled
    const Eigen::VectorXd tau =
        reference::inverse_dynamics<double>(robot, vector_of(at), vector_of(point.qd), vector_of(point.qdd));
    for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(history.tau[k][i], tau[static_cast<Eigen::Index>(i)], 1e-12);
  }
}

// Links of 0.15 and 0.3 m: a slider that drives does not get further than 0.45 m, and there the loop is singular.
TEST(ClosedPositions, EndWhereTheLoopsDo) {
  std::string text = testing::text_of_robot("slider_crank.toml");
  const std::string dependent = R"(dependent = ["theta_2", "x"])";
  text.replace(text.find(dependent), dependent.size(), R"(dependent = ["theta_1", "theta_2"])");
  const LoadedRobot model = testing::model_of_toml(text);
  ClosedPositions closed(model);
  const double before = 0.44, beyond = 0.46;
  const std::span<const double> q = closed.of({&before, 1});
  EXPECT_NEAR(0.15 * std::cos(q[0]) + 0.3 * std::cos(q[0] + q[1]), 0.44, 1e-14);
  EXPECT_GT(q[0], 0);
  try {
    closed.of({&beyond, 1});
    FAIL() << "nothing thrown";
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.kind(), FailureKind::input);
    EXPECT_NE(std::string(failure.what()).find("the loops cannot be closed beyond x = 0.4"), std::string::npos)
        << failure.what();
  }
}

TEST(ClosedPositions, NeedAnAssembly) {
  std::string text = testing::text_of_robot("five_bar.toml");
  text.erase(text.find("[assembly]"), text.find("[tip]") - text.find("[assembly]"));
  const LoadedRobot model = testing::model_of_toml(text);
  EXPECT_THROW(ClosedPositions{model}, Failure);  // all links in line
}

}  // namespace
}  // namespace flatdyn
