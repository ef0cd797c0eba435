// SPDX-License-Identifier: GPL-2.0-or-later
// Simulated motion of robots with a floating base against laws that hold whatever their joints do.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "laboratory/simulate/simulator.hpp"
#include "support/floating_robots.hpp"
#include "support/written_model.hpp"

namespace flatdyn {
namespace {

using Eigen::Vector3d;

SimulatedMotion flown(const LoadedRobot& model, const Simulation& simulation) {
  Progress silent(true);
  JointDynamics dynamics(model, silent);
  return simulate(simulation, dynamics, [](double) { return false; });
}

// A body that tumbles about its middle axis, thrown with its base turned.
Simulation tumbling(const LoadedRobot& model, IntegrationMethod method) {
  Simulation simulation = resting(model.robot, model.mechanism);
  simulation.base = {{1, 2, 3}, {0.5, 0.5, -0.5, 0.5}};
  simulation.qd = {0.4, -0.3, 2, 0.05, 6, 0.1};
  simulation.duration = 2;
  simulation.rate = 50;
  simulation.method = method;
  simulation.tolerance = 1e-11;
  return simulation;
}

Eigen::Quaterniond orientation_of(const SimulationRow& row) {
  const auto& [w, x, y, z] = row.base->pose.orientation;
  return {w, x, y, z};
}

// The centre of mass of testing::kDrone in the world.
Vector3d centre_of(const SimulationRow& row) {
  const auto& p = row.base->pose.position;
  return Vector3d(p[0], p[1], p[2]) + orientation_of(row) * Vector3d(0.01, 0.02, -0.03);
}

TEST(FloatingSimulation, OfABodyIsFreeFallAboutItsCentre) {
  const LoadedRobot drone = testing::model_of_toml(testing::kDrone);
  const SimulatedMotion motion = flown(drone, tumbling(drone, IntegrationMethod::adaptive));
  const SimulationRow &first = motion.rows.front(), &last = motion.rows.back();
  const Vector3d velocity = first.base->momentum.linear / 1.5, g(0, 0, -9.81);
  for (const SimulationRow& row : motion.rows) {
    const Vector3d fallen = centre_of(first) + velocity * row.time + g * (row.time * row.time / 2);
    EXPECT_LT((centre_of(row) - fallen).norm(), 1e-8) << row.time;
    EXPECT_NEAR(orientation_of(row).norm(), 1, 4e-16);
    EXPECT_LT((row.base->gravity - orientation_of(row).conjugate() * g).norm(), 1e-14);
  }
  EXPECT_LT((last.base->momentum.angular - first.base->momentum.angular).norm(), 1e-8);
  EXPECT_LT(energy_error(motion), 1e-8);
}

// The moment of momentum is kept to the order of the integrator.
TEST(FloatingSimulation, KeepsAngularMomentumToTheOrderOfTheIntegrator) {
  const LoadedRobot drone = testing::model_of_toml(testing::kDrone);
  Simulation simulation = tumbling(drone, IntegrationMethod::rk4);
  double error[2] = {};
  for (int k = 0; k < 2; ++k) {
    simulation.step = k == 0 ? 0.01 : 0.005;
    error[k] = momentum_error(flown(drone, simulation)).angular.norm();
  }
  EXPECT_LT(error[0], 1e-3);
  EXPECT_GT(error[1], 1e-13);
  EXPECT_GT(std::log2(error[0] / error[1]), 3.5);
}

// Motors move the arm, and the bus against it: what they do between links adds no momentum.
TEST(FloatingSimulation, OfASatelliteAccountsForMomentum) {
  const LoadedRobot satellite = testing::model_of_toml(testing::kSatellite);
  Simulation simulation = resting(satellite.robot, satellite.mechanism);
  simulation.duration = 1;
  simulation.rate = 20;
  simulation.tolerance = 1e-11;
  simulation.constant = {0.5, 0, -1, 0.1, 0, 0.2, 0, 0, 0};
  FeedbackLaw law{FeedbackLaw::Kind::pd, {0, 0, 0, 0, 0, 0, 30, 80, 4}, {0, 0, 0, 0, 0, 0, 8, 30, 1}, {}, false, {}};
  law.position = {9, 9, 9, 9, 9, 9, 1.2, 0.3, -0.8};  // the first six have no meaning
  simulation.feedback = law;
  const SimulatedMotion motion = flown(satellite, simulation);
  const Momentum error = momentum_error(motion);
  EXPECT_LT(error.linear.norm(), 1e-8);
  EXPECT_LT(error.angular.norm(), 1e-8);
  EXPECT_LT(energy_error(motion), 1e-7);
  EXPECT_GT(std::abs(motion.rows.back().q(0)), 0.3);
  EXPECT_GT(motion.rows.back().base->impulse.angular.norm(), 0.05);
  EXPECT_EQ(motion.rows.back().tau(2), -1);
}

// The armature and friction of its base take momentum from the links, and friction takes energy.
TEST(FloatingSimulation, OfABaseWithArmatureAccountsForMomentum) {
  const LoadedRobot satellite = testing::model_of_toml(testing::heavy_satellite());
  Simulation simulation = resting(satellite.robot, satellite.mechanism);
  simulation.duration = 1;
  simulation.rate = 20;
  simulation.tolerance = 1e-11;
  simulation.constant = {5, 0, -4, 3, 0, 2, 0.5, 0.1, 0.3};
  const SimulatedMotion motion = flown(satellite, simulation);
  const Momentum error = momentum_error(motion);
  EXPECT_LT(error.linear.norm(), 1e-8);
  EXPECT_LT(error.angular.norm(), 1e-8);
  EXPECT_LT(energy_error(motion), 1e-7);
  EXPECT_GT(motion.rows.back().qd.head<3>().norm(), 0.1);
  EXPECT_GT(motion.rows.back().qd.segment<3>(3).norm(), 0.05);
}

// Thrust that carries the weight through the centre of mass holds a drone at rest where it is.
TEST(FloatingSimulation, HoversOnItsThrust) {
  const LoadedRobot drone = testing::model_of_toml(testing::kDrone);
  Simulation simulation = resting(drone.robot, drone.mechanism);
  const double weight = 1.5 * 9.81;
  simulation.constant = {0, 0, weight, 0.02 * weight, -0.01 * weight, 0};
  simulation.duration = 1;
  simulation.rate = 2;
  const SimulatedMotion motion = flown(drone, simulation);
  for (const SimulationRow& row : motion.rows) {
    EXPECT_LT(row.qd.norm(), 1e-12);
    EXPECT_LT(std::abs(row.base->pose.position[2]), 1e-12);
  }
}

}  // namespace
}  // namespace flatdyn
