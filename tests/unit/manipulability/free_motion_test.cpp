// SPDX-License-Identifier: GPL-2.0-or-later
// Ellipsoids of robots with floating bases and with spherical joints, compared with accelerations of the tip that the
// recursive reference finds for single torques.
#include <gtest/gtest.h>

#include <filesystem>

#include "flatdyn/reference/kinematics.hpp"
#include "laboratory/manipulability/ellipsoid.hpp"
#include "support/floating_robots.hpp"
#include "support/written_model.hpp"
#include "truth/reference/reference_model.hpp"

namespace flatdyn {
namespace {

using testing::model_of_toml;

LoadedRobot example(const std::string& file, const LoadOptions& options = {}) {
  return load_robot(std::filesystem::path(FLATDYN_SOURCE_DIR) / "docs" / "examples" / file, options);
}

LoadedRobot floating_panda() {
  LoadOptions options;
  options.read.floating_base = true;
  return load_robot(std::filesystem::path(FLATDYN_SOURCE_DIR) / "robots" / "panda.urdf", options);
}

// A robot at rest that only joint torques and gravity act on, by forward dynamics and the motion of links.
class RobotAtRest {
 public:
  RobotAtRest(const LoadedRobot& model, const std::vector<double>& q, const Eigen::Vector3d& g_b)
      : robot_(reference_robot<double>(model.robot, {})),
        q_(Eigen::VectorXd::Map(q.data(), static_cast<Eigen::Index>(q.size()))) {
    reference::take_orientations(robot_, q_);
    if (robot_.floating_base) robot_.gravity = g_b;
  }

  Eigen::Index joints() const { return robot_.size() - robot_.base_size(); }

  // q̈, or v̇ of spherical joints, for these torques, and the tip's acceleration in the six directions, base axes.
  Eigen::VectorXd joint_accelerations(const Eigen::VectorXd& tau) const { return accelerations(tau).tail(joints()); }
  Eigen::VectorXd tip_acceleration(const Eigen::VectorXd& tau) const {
    const Eigen::VectorXd rest = Eigen::VectorXd::Zero(robot_.size());
    const auto motions = reference::link_motions(robot_, q_, rest, accelerations(tau), false);
    const auto& tip = motions[static_cast<std::size_t>(robot_.tip)];
    Eigen::VectorXd a(6);
    a << tip.R * (tip.ddp + tip.domega.cross(robot_.p_tip)), tip.R * tip.domega;
    return a;
  }

  Eigen::VectorXd centre(const std::vector<int>& task) const {
    return tip_acceleration(Eigen::VectorXd::Zero(joints()))(task);
  }
  // The tip's accelerations by unit torques, less those without torque: J B^-1 by columns.
  Eigen::MatrixXd tip_by_torques(const std::vector<int>& task) const {
    Eigen::MatrixXd columns(static_cast<Eigen::Index>(task.size()), joints());
    for (Eigen::Index k = 0; k < joints(); ++k) {
      columns.col(k) = tip_acceleration(Eigen::VectorXd::Unit(joints(), k))(task) - centre(task);
    }
    return columns;
  }
  Eigen::MatrixXd joints_by_torques() const {
    const Eigen::VectorXd fall = joint_accelerations(Eigen::VectorXd::Zero(joints()));
    Eigen::MatrixXd columns(joints(), joints());
    for (Eigen::Index k = 0; k < joints(); ++k) {
      columns.col(k) = joint_accelerations(Eigen::VectorXd::Unit(joints(), k)) - fall;
    }
    return columns;
  }

 private:
  Eigen::VectorXd accelerations(const Eigen::VectorXd& tau) const {
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(robot_.size());
    forces.tail(joints()) = tau;
    return reference::forward_dynamics(robot_, q_, Eigen::VectorXd(Eigen::VectorXd::Zero(robot_.size())), forces);
  }

  reference::Robot<double> robot_;
  Eigen::VectorXd q_;
};

Ellipsoid ellipsoid_of(const LoadedRobot& model, const std::vector<double>& q, const Eigen::Vector3d& g_b,
                       const TorqueBall& torques, std::vector<int>& task) {
  Progress progress(true);
  Manipulability arm(model, torques, progress);
  task = arm.task();
  return arm.at(q, g_b);
}

// A A' for the half axes as columns of A: the image of the unit ball, whatever the order and signs of its axes.
Eigen::MatrixXd square_of(const Ellipsoid& ellipsoid) {
  const Eigen::MatrixXd half = ellipsoid.axes * ellipsoid.lengths.asDiagonal();
  return half * half.transpose();
}

void expect_close(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, double tolerance) {
  ASSERT_EQ(a.rows(), b.rows());
  ASSERT_EQ(a.cols(), b.cols());
  EXPECT_LE((a - b).norm(), tolerance * b.norm());
}

// Both ellipsoids, for torques of this norm in units of `unit`.
void compare(const LoadedRobot& model, const std::vector<double>& q, const Eigen::Vector3d& g_b, TorqueNorm norm,
             const Eigen::VectorXd& unit) {
  SCOPED_TRACE(model.mechanism.name);
  std::vector<int> task;
  const Ellipsoid all = ellipsoid_of(model, q, g_b, {norm, 2, TorqueSet::all}, task);
  const RobotAtRest robot(model, q, g_b);
  ASSERT_EQ(unit.size(), robot.joints());
  expect_close(all.centre, robot.centre(task), 1e-9);
  const Eigen::MatrixXd image = robot.tip_by_torques(task) * (2 * unit).asDiagonal();
  expect_close(square_of(all), image * image.transpose(), 1e-8);
  // (7.148): of the joint accelerations that make an acceleration of the tip, the smallest take torques of the norm.
  const Ellipsoid least = ellipsoid_of(model, q, g_b, {norm, 2, TorqueSet::least_accelerations}, task);
  EXPECT_EQ(least.centre, all.centre);
  const Eigen::MatrixXd B = robot.joints_by_torques().inverse(), J = robot.tip_by_torques(task) * B;
  const Eigen::MatrixXd inverse = J.completeOrthogonalDecomposition().pseudoInverse();
  for (Eigen::Index k = 0; k < least.lengths.size(); ++k) {
    const Eigen::VectorXd tau = B * (inverse * least.axes.col(k)) * least.lengths(k);
    EXPECT_NEAR(tau.cwiseQuotient(unit).norm(), 2, 1e-7);
    EXPECT_NEAR((J * inverse * least.axes.col(k) - least.axes.col(k)).norm(), 0, 1e-8);
  }
  EXPECT_TRUE((least.axes.transpose() * least.axes).isIdentity(1e-12));
  EXPECT_LE(least.measure, all.measure * (1 + 1e-9));
}

std::vector<double> unit_quaternions(std::vector<double> q, const LoadedRobot& model) {
  for (const int first : model.mechanism.quaternions()) {
    Eigen::Map<Eigen::Vector4d> quaternion(q.data() + first);
    quaternion.normalize();
  }
  return q;
}

constexpr const char* kBallPendulum = R"(name = "pendulum"
[[link]]
joint = "ball"
type = "spherical"
mass = 1.5
com = [0.05, 0, -0.4]
inertia = { xx = 0.02, yy = 0.03, zz = 0.01 }
inertia_about = "com"
[tip]
link = "link1"
xyz = [0, 0, -0.7]
)";

const Eigen::Vector3d kGravity(1, -4, -8.5);

TEST(FreeManipulability, IsThatOfSingleTorquesWithSphericalJoints) {
  LoadOptions limited;
  limited.read.scene_file = std::string(FLATDYN_SOURCE_DIR) + "/docs/examples/ball_wrist_limits.toml";
  const LoadedRobot wrist = example("ball_wrist.toml", limited);
  const std::vector<double> q = unit_quaternions({0.2, 0.4, 0.7, 0.1, 0.7, 0.1, 0.3, 0.02}, wrist);
  Eigen::VectorXd limits(7);
  limits << 60, 60, 20, 20, 20, 2, 10;
  compare(wrist, q, {}, TorqueNorm::plain, Eigen::VectorXd::Ones(7));
  compare(wrist, q, {}, TorqueNorm::limits, limits);
  const LoadedRobot pendulum = model_of_toml(kBallPendulum);
  compare(pendulum, unit_quaternions({0.3, 0.5, -0.2, 0.4}, pendulum), {}, TorqueNorm::plain, Eigen::VectorXd::Ones(3));
}

TEST(FreeManipulability, IsThatOfSingleTorquesWithAFloatingBase) {
  const LoadedRobot free_arm = example("free_arm.toml");
  const std::vector<double> q = unit_quaternions({0.3, 0.7, 0.1, 0.7, 0.1, 0.05, 0.2}, free_arm);
  compare(free_arm, q, kGravity, TorqueNorm::plain, Eigen::VectorXd::Ones(6));
  const LoadedRobot panda = floating_panda();
  Eigen::VectorXd limits(7);
  limits << 87, 87, 87, 87, 12, 12, 12;
  compare(panda, {0.1, -0.8, 0.3, -2.3, 0.2, 1.6, 0.8}, kGravity, TorqueNorm::limits, limits);
  compare(model_of_toml(testing::kSatellite), {0.4, 0.1, -0.7}, kGravity, TorqueNorm::plain, Eigen::VectorXd::Ones(3));
}

TEST(FreeManipulability, HasCoupledJointsAndSpringsOnAFloatingBase) {
  const LoadedRobot lander = model_of_toml(testing::kLander);
  std::vector<double> q(static_cast<std::size_t>(lander.mechanism.position_count()));
  for (std::size_t k = 0; k < q.size(); ++k) q[k] = 0.3 - 0.2 * static_cast<double>(k);
  compare(lander, q, kGravity, TorqueNorm::plain, Eigen::VectorXd::Ones(static_cast<Eigen::Index>(q.size())));
  std::string sprung = testing::kSatellite;
  const std::string mass = "mass = 3\n";
  sprung.replace(sprung.find(mass), mass.size(), mass + "stiffness = 40\nspring_reference = 0.2\n");
  const LoadedRobot satellite = model_of_toml(sprung);
  ASSERT_TRUE(satellite.mechanism.has_springs());
  compare(satellite, {0.9, 0.1, -0.7}, kGravity, TorqueNorm::plain, Eigen::VectorXd::Ones(3));
}

// All parts fall alike: without torques and springs the tip falls with the base, whatever the posture.
TEST(FreeManipulability, FallsWithTheBase) {
  std::vector<int> task;
  const Ellipsoid ellipsoid = ellipsoid_of(floating_panda(), {0.1, -0.8, 0.3, -2.3, 0.2, 1.6, 0.8}, kGravity, {}, task);
  EXPECT_EQ(task, (std::vector{0, 1, 2}));
  EXPECT_EQ(ellipsoid.centre, kGravity);
}

std::string arm_with_ball(const std::string& base) {
  return base + R"([[link]]
joint = "hinge"
xyz = [0.4, 0.1, 0.2]
rpy = [0.3, "pi/2", 0]
mass = 3
com = [0.2, 0.1, 0]
inertia = { xx = 0.03, yy = 0.04, zz = 0.05 }
inertia_about = "com"
[[link]]
joint = "ball"
type = "spherical"
xyz = [0.4, 0, 0.1]
mass = 2
com = [0.05, -0.02, 0.1]
inertia = { xx = 0.03, yy = 0.02, zz = 0.025 }
inertia_about = "com"
[tip]
link = "link2"
xyz = [0.3, 0.1, 0]
)";
}

// On a base of 10^9 kg and kg m^2 the arm accelerates as on one that is held, by about 10^-9 of it. The base falls
// nevertheless, and with it the tip.
TEST(FreeManipulability, TendsToThatOfAFixedBase) {
  const LoadedRobot fixed = model_of_toml(arm_with_ball("name = \"arm\"\n"));
  const LoadedRobot heavy =
      model_of_toml(arm_with_ball("name = \"arm\"\n[base]\nmotion = \"floating\"\nmass = 1e9\ninertia = { xx = 1e9, yy "
                                  "= 1e9, zz = 1e9 }\ninertia_about = \"com\"\n"));
  const LoadedRobot light =
      model_of_toml(arm_with_ball("name = \"arm\"\n[base]\nmotion = \"floating\"\nmass = 9\ninertia = { xx = 1, yy = "
                                  "1, zz = 1 }\ninertia_about = \"com\"\n"));
  const std::vector<double> q = unit_quaternions({0.3, 0.7, 0.1, 0.7, 0.1}, fixed);
  for (const TorqueSet set : {TorqueSet::least_accelerations, TorqueSet::all}) {
    std::vector<int> task;
    const TorqueBall torques{TorqueNorm::plain, 5, set};
    const Ellipsoid held = ellipsoid_of(fixed, q, {}, torques, task);
    const Ellipsoid floating = ellipsoid_of(heavy, q, kGravity, torques, task);
    expect_close(square_of(floating), square_of(held), 1e-6);
    EXPECT_EQ(floating.centre, kGravity);
    EXPECT_GT((square_of(ellipsoid_of(light, q, kGravity, torques, task)) - square_of(held)).norm(),
              0.05 * square_of(held).norm());
  }
}

std::string point_on_a_rod(double mass_of_base) {
  return "name = \"rod\"\n[base]\nmotion = \"floating\"\nmass = " + std::to_string(mass_of_base) +
         "\ninertia = { xx = 1, yy = 1, zz = 1 }\ninertia_about = \"com\"\n[[link]]\njoint = \"a\"\nmass = 2\ncom = "
         "[0.5, 0, 0]\n"
         "[tip]\nlink = \"link1\"\nxyz = [0.5, 0, 0]\n";
}

// A point of 2 kg at the end of a massless rod of 0.5 m, hinged to the base's centre of mass: a torque of 1 N m exerts
// 2 N on it, across the rod, so that it accelerates by 1 m/s^2, whatever the base weighs.
TEST(FreeManipulability, IsKnownForAPointOnARod) {
  for (const double mass : {0.5, 7.0, 1e4}) {
    std::vector<int> task;
    const Ellipsoid ellipsoid = ellipsoid_of(model_of_toml(point_on_a_rod(mass)), {0.6}, kGravity, {}, task);
    EXPECT_EQ(task, (std::vector{0, 1}));
    ASSERT_EQ(ellipsoid.lengths.size(), 1);
    EXPECT_NEAR(ellipsoid.measure, 1, 1e-12) << mass;
    EXPECT_NEAR(std::abs(ellipsoid.axes.col(0).dot(Eigen::Vector2d(-std::sin(0.6), std::cos(0.6)))), 1, 1e-12);
    EXPECT_EQ(ellipsoid.centre, kGravity.head<2>());
  }
}

LoadedRobot two_arms(const std::vector<int>& task = {}) {
  std::string text = "name = \"two_arms\"\n";
  text +=
      "[base]\nname = \"bus\"\nmotion = \"floating\"\nmass = 9\ninertia = { xx = 1, yy = 1, zz = 1 }\ninertia_about = "
      "\"com\"\n";
  for (const char* side : {"right", "left"}) {
    for (const char* part : {"upper", "lower"}) {
      const std::string name = std::string(side) + "_" + part;
      const bool is_upper = part == std::string("upper");
      text += "[[link]]\nname = \"" + name + "\"\njoint = \"" + name + "_joint\"\nparent = \"" +
              (is_upper ? "bus" : std::string(side) + "_upper") + "\"\nxyz = [" +
              (!is_upper                      ? "0.6"
               : side == std::string("right") ? "0.5"
                                              : "-0.5") +
              ", 0, 0]\nmass = 2\ncom = [0.3, 0, 0]\ninertia = { yy = 0.06, zz = 0.06 }\ninertia_about = \"com\"\n";
    }
  }
  LoadedRobot model = model_of_toml(text + "[tip]\nlink = \"right_lower\"\nxyz = [0.6, 0, 0]\n");
  model.mechanism.task.rows = task;
  return model;
}

// The other arm moves the tip, too: by the base's reaction, which all torques use.
TEST(FreeManipulability, CountsTheReactionOfAnotherArm) {
  const LoadedRobot model = two_arms();
  const std::vector<double> q = {0.4, 0.9, 2.2, -0.8};
  compare(model, q, kGravity, TorqueNorm::plain, Eigen::VectorXd::Ones(4));
  std::vector<int> task;
  ellipsoid_of(model, q, kGravity, {}, task);
  EXPECT_EQ(task, (std::vector{0, 1}));
  EXPECT_GT(RobotAtRest(model, q, kGravity).tip_by_torques(task).rightCols(2).norm(), 1e-2);
}

TEST(FreeManipulability, KnowsWhichDirectionsJointsReach) {
  Progress progress(true);
  EXPECT_EQ(Manipulability(two_arms({0, 1, 5}), {}, progress).task(), (std::vector{0, 1, 5}));
  try {
    Manipulability(two_arms({0, 1, 2}), {}, progress);
    FAIL();
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.kind(), FailureKind::unsupported);
    EXPECT_EQ(std::string(failure.what()),
              "joints cannot accelerate the tip \"right_lower\" along x, y, z independently while the base floats");
    EXPECT_EQ(failure.hint(), "of the scene's `task` they can along x, y");
  }
}

// A rod and a base of one line of mass: moments about it turn nothing.
TEST(FreeManipulability, IsRefusedWhereTheBaseTurnsNothing) {
  const LoadedRobot line = model_of_toml(
      "name = \"line\"\n[base]\nmotion = \"floating\"\nmass = 3\n[[link]]\njoint = \"a\"\ntype = \"prismatic\"\n"
      "axis = [1, 0, 0]\nmass = 2\ncom = [0.5, 0, 0]\n[tip]\nlink = \"link1\"\nxyz = [0.5, 0, 0]\n");
  std::vector<int> task;
  try {
    ellipsoid_of(line, {0.1}, kGravity, {}, task);
    FAIL();
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.kind(), FailureKind::unsupported);
    EXPECT_EQ(std::string(failure.what()), "forces or moments on the floating base move no inertia");
  }
}

TEST(FreeManipulability, KnowsWhereTheArmIs) {
  Progress progress(true);
  Manipulability arm(two_arms(), {}, progress);
  const std::vector<Eigen::Vector3d> points = arm.skeleton({0.4, 0.9, 2.2, -0.8});
  ASSERT_EQ(points.size(), 4U);
  EXPECT_EQ(points[0], Eigen::Vector3d::Zero());
  EXPECT_LE((points[1] - Eigen::Vector3d(0.5, 0, 0)).norm(), 1e-15);
  EXPECT_LE((points[2] - points[1] - 0.6 * Eigen::Vector3d(std::cos(0.4), std::sin(0.4), 0)).norm(), 1e-15);
  EXPECT_LE((points[3] - points[2] - 0.6 * Eigen::Vector3d(std::cos(1.3), std::sin(1.3), 0)).norm(), 1e-15);
  Manipulability wrist(example("ball_wrist.toml"), {}, progress);
  EXPECT_EQ(wrist.skeleton({0, 0, 1, 0, 0, 0, 0, 0}).size(), 6U);  // base, two links, hand, finger, tip
}

TEST(FreeManipulability, NamesTheSphericalJointWithoutALimit) {
  Progress progress(true);
  try {
    Manipulability(model_of_toml(kBallPendulum), {TorqueNorm::limits}, progress);
    FAIL();
  } catch (const Failure& failure) {
    EXPECT_EQ(std::string(failure.what()), "joint \"ball\" has no effort limit");
  }
}

}  // namespace
}  // namespace flatdyn
