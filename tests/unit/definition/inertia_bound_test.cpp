// SPDX-License-Identifier: GPL-2.0-or-later
// The proven bound of B beside its diagonal, against eigenvalues at random positions.
#include "robot/model/inertia_bound.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "graph/arithmetic.hpp"
#include "robot/model/joint_points.hpp"
#include "robot/model/random_robot.hpp"
#include "robot/model/states.hpp"
#include "support/floating_robots.hpp"
#include "support/robot_models.hpp"
#include "support/written_model.hpp"
#include "truth/definition/lagrangian.hpp"

namespace flatdyn {
namespace {

// The smallest eigenvalue of B with its rows and columns scaled to a diagonal of ones, over random positions.
double smallest_eigenvalue(const Mechanism& mechanism) {
  double smallest = 1;
  for (const State& state : random_states(mechanism, 20, 1)) {
    RealArithmetic<double> numbers(
        [&state](const Input& input) { return state.of(input.kind)[static_cast<std::size_t>(input.index)]; });
    Lagrangian<double> lagrangian(mechanism_over(mechanism, numbers), joint_points(mechanism, numbers));
    const Matrix<double> inertia = lagrangian.inertia();
    Eigen::MatrixXd B(inertia.rows(), inertia.rows());
    for (int i = 0; i < inertia.rows(); ++i) {
      for (int j = 0; j < inertia.rows(); ++j) B(i, j) = inertia(i, j);
    }
    const Eigen::VectorXd scale = B.diagonal().cwiseSqrt().cwiseInverse();
    B = scale.asDiagonal() * B * scale.asDiagonal();
    smallest =
        std::min(smallest, Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(B, Eigen::EigenvaluesOnly).eigenvalues()(0));
  }
  return smallest;
}

class BoundOfRobot : public ::testing::TestWithParam<const char*> {};

// The bound is below what occurs, and large enough to be of use.
TEST_P(BoundOfRobot, IsBelowEveryEigenvalue) {
  const Mechanism mechanism = testing::model_of(GetParam()).mechanism;
  EXPECT_LE(scaled_inertia_bound(mechanism), smallest_eigenvalue(mechanism));
  EXPECT_GT(scaled_inertia_bound(mechanism), 0x1p-15);
}

INSTANTIATE_TEST_SUITE_P(Robots, BoundOfRobot,
                         ::testing::Values("humanoid32.urdf", "panda.urdf", "puma560.toml", "quadruped12.urdf",
                                           "rx90.toml", "ur5.urdf", "planar_2r_example_7_2.toml"));

// The base's velocities are of other units than the joints'; its rows and columns are scaled, too.
TEST(ScaledInertiaBound, HoldsForFloatingBases) {
  LoadOptions floating;
  floating.read.floating_base = true;
  for (const char* file : {"quadruped12.urdf", "humanoid32.urdf", "rx90.toml", "puma560.toml"}) {
    const Mechanism mechanism = load_robot(std::string(FLATDYN_SOURCE_DIR "/robots/") + file, floating).mechanism;
    EXPECT_LE(scaled_inertia_bound(mechanism), smallest_eigenvalue(mechanism) + 1e-12) << file;
  }
  const Mechanism quadruped = load_robot(FLATDYN_SOURCE_DIR "/robots/quadruped12.urdf", floating).mechanism;
  EXPECT_GT(scaled_inertia_bound(quadruped), 0x1p-15);
  Mechanism massless = testing::model_of_toml(testing::kDrone).mechanism;
  EXPECT_GT(scaled_inertia_bound(massless), 0.05);
  massless.bodies[5].inertia.inertia = zero_matrix();
  EXPECT_EQ(scaled_inertia_bound(massless), 0);
}

// Links with rotors that others carry, prismatic joints, branches and links without mass are among them.
TEST(ScaledInertiaBound, HoldsForRandomRobots) {
  int proven = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    const Mechanism mechanism = make_mechanism(random_robot(seed % 2 == 0, 1 + static_cast<int>(seed % 6), seed));
    if (!mechanism.symbols.empty() || mechanism.has_loops()) continue;
    const double bound = scaled_inertia_bound(mechanism);
    if (bound == 0) continue;
    ++proven;
    EXPECT_LE(bound, smallest_eigenvalue(mechanism) + 1e-12) << "seed " << seed;
  }
  EXPECT_GT(proven, 50);
}

// The armature turns by c - 100 b, so it resists no change of c and b at that rate: B is nearly singular.
TEST(ScaledInertiaBound, IsZeroWhereAJointTurnsByACombinationOfCoordinates) {
  const auto arm = [](const std::string& position) {
    const std::string link =
        "[[link]]\nxyz = [0.1, 0, 0]\nmass = 0.3\ncom = [0.05, 0.02, 0.01]\n"
        "inertia_about = \"com\"\ninertia = { xx = 0.05, yy = 0.055, zz = 0.06 }\n";
    return testing::model_of_toml(link + "joint = \"b\"\n" + link + "rpy = [0.7, -0.4, 0.2]\njoint = \"c\"\n" +
                                  "armature = 1\n" + position);
  };
  EXPECT_GT(scaled_inertia_bound(arm("").mechanism), 1e-3);
  const Mechanism coupled = arm("position = \"c - 100*b\"").mechanism;
  EXPECT_LT(smallest_eigenvalue(coupled), 1e-4);
  EXPECT_EQ(scaled_inertia_bound(coupled), 0);
}

TEST(ScaledInertiaBound, IsZeroWhereALinkHasNoInertia) {
  const auto arm = [](const std::string& of_first) {
    return testing::model_of_toml(R"(
[[link]]
)" + of_first + R"(
[[link]]
xyz = [0.7, 0, 0]
mass = 2.3
com = [0.4, 0, 0]
inertia_about = "com"
inertia = { xx = 1, yy = 1, zz = 1 }
)");
  };
  EXPECT_EQ(scaled_inertia_bound(arm("").mechanism), 0);
  EXPECT_GT(scaled_inertia_bound(arm("inertia_about = \"com\"\ninertia = { zz = 1 }").mechanism), 0);
  EXPECT_EQ(scaled_inertia_bound(testing::model_of_toml("[[link]]\n").mechanism), 0);
}

TEST(ScaledInertiaBound, AsksForLimitsOfAJointThatSlides) {
  const auto arm = [](const std::string& limits) {
    return testing::model_of_toml(R"(
[[link]]
inertia_about = "com"
inertia = { xx = 1, yy = 1, zz = 1 }
mass = 1
[[link]]
type = "prismatic"
mass = 1
)" + limits);
  };
  EXPECT_EQ(scaled_inertia_bound(arm("").mechanism), 0);
  const Mechanism limited = arm("limits = { lower = -1, upper = 2 }").mechanism;
  EXPECT_GT(scaled_inertia_bound(limited), 0);
  EXPECT_LE(scaled_inertia_bound(limited), smallest_eigenvalue(limited));
}

}  // namespace
}  // namespace flatdyn
