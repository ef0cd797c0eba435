// SPDX-License-Identifier: GPL-2.0-or-later
// Simulated motion of robots with spherical joints against the same motion with joints of one axis, and against laws
// that hold in free flight.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <string>

#include "laboratory/simulate/simulator.hpp"
#include "support/written_model.hpp"

namespace flatdyn {
namespace {

constexpr const char* kBob = R"(
mass = 1.5
com = [0.05, 0, -0.4]
inertia = { xx = 0.02, yy = 0.03, zz = 0.01 }
inertia_about = "com"
viscous = 0.02
)";

std::string hanging(const std::string& joint) { return "[[link]]\njoint = \"ball\"\n" + joint + kBob; }

SimulatedMotion swung(const LoadedRobot& model, const Simulation& simulation) {
  Progress silent(true);
  JointDynamics dynamics(model, silent);
  return simulate(simulation, dynamics, [](double) { return false; });
}

Simulation for_a_second(const LoadedRobot& model) {
  Simulation simulation = resting(model.robot, model.mechanism);
  simulation.duration = 1;
  simulation.rate = 10;
  simulation.tolerance = 1e-11;
  return simulation;
}

// A pendulum that swings about y stays in its plane.
TEST(SphericalSimulation, SwingsInAPlaneAsAHingeDoes) {
  const LoadedRobot hinge = testing::model_of_toml(hanging("axis = [0, 1, 0]\n")),
                    ball = testing::model_of_toml(hanging("type = \"spherical\"\n"));
  Simulation of_hinge = for_a_second(hinge), of_ball = for_a_second(ball);
  of_hinge.q = {0.7};
  of_hinge.qd = {3};
  of_ball.q = {0, std::sin(0.35), 0};
  of_ball.w = {std::cos(0.35)};
  of_ball.qd = {0, 3, 0};
  const SimulatedMotion wanted = swung(hinge, of_hinge), found = swung(ball, of_ball);
  ASSERT_EQ(found.rows.size(), wanted.rows.size());
  for (std::size_t k = 0; k < found.rows.size(); ++k) {
    const Eigen::VectorXd& q = found.rows[k].q;
    ASSERT_EQ(q.size(), 4);
    EXPECT_NEAR(q.norm(), 1, 4e-16);
    const double half = wanted.rows[k].q[0] / 2;
    EXPECT_NEAR(std::abs(q[0] * std::cos(half) + q[2] * std::sin(half)), 1, 1e-14) << k;
    EXPECT_NEAR(found.rows[k].qd[1], wanted.rows[k].qd[0], 1e-8) << k;
    EXPECT_NEAR(found.rows[k].kinetic, wanted.rows[k].kinetic, 1e-8) << k;
  }
  EXPECT_LT(energy_error(found), 1e-8);
}

// Two bodies that a ball joint holds together, thrown.
TEST(SphericalSimulation, KeepsEnergyAndMomentumInFreeFlight) {
  const std::string trunk =
      "[base]\nmotion = \"floating\"\nmass = 3\ninertia = { xx = 0.1, yy = 0.2, zz = 0.25 }\ninertia_about = \"com\"\n";
  const LoadedRobot model = testing::model_of_toml(trunk + hanging("type = \"spherical\"\nxyz = [0.2, 0.1, 0]\n"));
  Simulation simulation = for_a_second(model);
  simulation.base.orientation = {0.5, 0.5, -0.5, 0.5};
  simulation.q = {0, 0, 0, 0, 0, 0, 0.5, -0.5, 0.1};
  simulation.w = {0.7};
  simulation.qd = {0.4, -0.3, 2, 0.05, 3, 0.1, -4, 2, 5};
  const SimulatedMotion motion = swung(model, simulation);
  const Momentum error = momentum_error(motion);
  EXPECT_LT(error.linear.norm(), 1e-8);
  EXPECT_LT(error.angular.norm(), 1e-8);
  EXPECT_LT(energy_error(motion), 1e-8);
  EXPECT_GT(motion.rows.back().dissipated, 0.01);
}

}  // namespace
}  // namespace flatdyn
