// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/manipulability/ellipsoid.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "flatdyn/reference/kinematics.hpp"
#include "support/robot_models.hpp"
#include "support/written_model.hpp"
#include "truth/reference/reference_model.hpp"

namespace flatdyn {
namespace {

using testing::model_of;
using testing::model_of_toml;

// The recursive reference's quantities at a position.
struct ArmPose {
  Eigen::MatrixXd B, J;
  Eigen::VectorXd g;

  ArmPose(const LoadedRobot& model, const std::vector<double>& q, const std::vector<int>& task) {
    const auto arm = reference_robot<double>(model.robot, {});
    const Eigen::VectorXd at = Eigen::Map<const Eigen::VectorXd>(q.data(), static_cast<Eigen::Index>(q.size()));
    B = reference::inertia_matrix(arm, at);
    g = reference::gravity(arm, at);
    J = Eigen::MatrixXd(reference::jacobian(arm, at)(task, Eigen::all));
  }
};

Ellipsoid ellipsoid_of(const LoadedRobot& model, const std::vector<double>& q, double radius, std::vector<int>& task,
                       TorqueSet set = TorqueSet::least_accelerations) {
  Progress progress(true);
  Manipulability arm(model, {TorqueNorm::plain, radius, set}, progress);
  task = arm.task();
  return arm.at(q);
}

constexpr const char* kPendulum = R"(name = "pendulum"
gravity = [0, "-9.81", 0]
[[link]]
joint = "theta"
mass = 2
com = [0.4, 0, 0]
[tip]
link = "link1"
xyz = [0.5, 0, 0]
)";

LoadedRobot planar_3r() {
  std::string text = "name = \"planar_3r\"\ngravity = [0, \"-9.81\", 0]\ndh = \"standard\"\n";
  for (const char* joint : {"a", "b", "c"}) {
    text += std::string("[[link]]\njoint = \"") + joint +
            "\"\na = 1\nmass = 10\ncom = [-0.5, 0, 0]\ninertia = { yy = 0.8, zz = 0.8 }\ninertia_about = \"com\"\n";
  }
  return model_of_toml(text);
}

// (7.148): the torques B J† (v̇ + J B^-1 g) of accelerations on the ellipsoid all have the given norm.
TEST(Manipulability, EndsOfTheAxesTakeTorquesOfTheNorm) {
  for (const auto& [model, q] : {std::pair{model_of("planar_2r_example_7_2.toml"), std::vector{0.5, 1.0}},
                                 std::pair{planar_3r(), std::vector{1.9, -1.2, -0.9}},
                                 std::pair{model_of("panda.urdf"), std::vector{0.1, -0.8, 0.3, -2.3, 0.2, 1.6, 0.8}}}) {
    std::vector<int> task;
    const Ellipsoid ellipsoid = ellipsoid_of(model, q, 50, task);
    const ArmPose pose(model, q, task);
    const Eigen::VectorXd fall = -pose.J * pose.B.inverse() * pose.g;
    EXPECT_LE((ellipsoid.centre - fall).norm(), 1e-10 * fall.norm()) << model.mechanism.name;
    const Eigen::MatrixXd inverse = pose.J.completeOrthogonalDecomposition().pseudoInverse();
    for (Eigen::Index k = 0; k < ellipsoid.lengths.size(); ++k) {
      EXPECT_NEAR((pose.B * inverse * ellipsoid.axes.col(k) * ellipsoid.lengths(k)).norm(), 50, 1e-8);
      EXPECT_LE(ellipsoid.lengths(k), ellipsoid.lengths(0));
    }
    EXPECT_TRUE((ellipsoid.axes.transpose() * ellipsoid.axes).isIdentity(1e-12));
  }
}

// Whether an acceleration, less the centre, lies within the ellipsoid: its norm in units of the half axes.
double norm_in(const Ellipsoid& ellipsoid, const Eigen::VectorXd& a) {
  return (ellipsoid.axes.transpose() * a).cwiseQuotient(ellipsoid.lengths).norm();
}

// v̇ = J B^-1 (τ - g) of drawn torques of the norm: all lie within the ellipsoid, and in every direction some reach its
// surface. Torques B J† v̇ of least accelerations make less, and those of other accelerations leave their ellipsoid.
TEST(Manipulability, OfAllTorquesIsWhatDrawnTorquesReach) {
  srand(3);
  const LoadedRobot panda = model_of("panda.urdf");
  const std::vector<double> q = {0.1, -0.8, 0.3, -2.3, 0.2, 1.6, 0.8};
  for (const TorqueNorm norm : {TorqueNorm::plain, TorqueNorm::limits}) {
    Progress progress(true);
    Manipulability all_torques(panda, {norm, 2, TorqueSet::all}, progress), least(panda, {norm, 2}, progress);
    const Ellipsoid outer = all_torques.at(q), inner = least.at(q);
    const ArmPose pose(panda, q, all_torques.task());
    Eigen::VectorXd unit = Eigen::VectorXd::Constant(7, 2);
    if (norm == TorqueNorm::limits) unit << 174, 174, 174, 174, 24, 24, 24;
    const Eigen::MatrixXd image = pose.J * pose.B.inverse() * unit.asDiagonal();
    double farthest = 0, beyond = 0;
    for (int k = 0; k < 20000; ++k) {
      const Eigen::VectorXd a = image * Eigen::VectorXd::Random(7).normalized();
      farthest = std::max(farthest, norm_in(outer, a));
      beyond = std::max(beyond, norm_in(inner, a));
    }
    EXPECT_LE(farthest, 1 + 1e-10);
    EXPECT_GT(farthest, 0.99);
    EXPECT_GT(beyond, 1.05);
    for (int k = 0; k < 100; ++k) {  // the farthest point in a direction u is the image of τ along its transpose
      const Eigen::VectorXd u = Eigen::Vector3d::Random(), torque = (image.transpose() * u).normalized();
      EXPECT_NEAR(norm_in(outer, image * torque), 1, 1e-9);
      EXPECT_LE(norm_in(outer, inner.axes * inner.lengths.asDiagonal() * u.normalized()), 1 + 1e-9);
    }
    EXPECT_LE((outer.centre - inner.centre).norm(), 1e-12);
    EXPECT_NEAR(outer.measure, std::sqrt((image * image.transpose()).determinant()), 1e-9 * outer.measure);
    EXPECT_GT(outer.measure, inner.measure);
  }
}

// Without redundancy any torques make the accelerations of (7.148).
TEST(Manipulability, OfAllTorquesIsTheTextbooksWithoutRedundancy) {
  std::vector<int> task;
  const LoadedRobot arm = model_of("planar_2r_example_7_2.toml");
  for (const std::vector<double>& q : {std::vector{0.5, 1.0}, std::vector{0.3, 0.0}}) {
    const Ellipsoid least = ellipsoid_of(arm, q, 50, task), all = ellipsoid_of(arm, q, 50, task, TorqueSet::all);
    EXPECT_LE((all.lengths - least.lengths).norm(), 1e-12 * least.lengths(0));
    EXPECT_NEAR(std::abs(all.axes.col(0).dot(least.axes.col(0))), 1, 1e-12);
    EXPECT_EQ(all.centre, least.centre);
  }
  const Ellipsoid all = ellipsoid_of(model_of_toml(kPendulum), {0.5}, 1, task, TorqueSet::all);
  ASSERT_EQ(all.lengths.size(), 1);
  EXPECT_NEAR(all.measure, 0.5 / (2 * 0.16), 1e-14);
}

// Problem 7.12: for an arm without redundancy, √det(J Jᵀ) = w det B, where w is the measure for torques of norm 1.
TEST(Manipulability, MeasureIsThatOfTheJacobianOverTheInertia) {
  std::vector<int> task;
  const LoadedRobot model = model_of("planar_2r_example_7_2.toml");
  for (const std::vector<double>& q : {std::vector{0.5, 1.0}, std::vector{-2.0, 0.1}, std::vector{3.0, -2.5}}) {
    const Ellipsoid ellipsoid = ellipsoid_of(model, q, 1, task);
    const ArmPose pose(model, q, task);
    const double w = std::sqrt((pose.J * pose.J.transpose()).determinant());
    EXPECT_NEAR(ellipsoid.measure * pose.B.determinant(), w, 1e-12);
  }
}

// Stretched out, the arm's tip cannot be accelerated along the arm.
TEST(Manipulability, IsFlatWhereTheJacobianIsSingular) {
  std::vector<int> task;
  const Ellipsoid ellipsoid = ellipsoid_of(model_of("planar_2r_example_7_2.toml"), {0.3, 0}, 1, task);
  EXPECT_EQ(task, (std::vector{0, 1}));
  EXPECT_LE(ellipsoid.lengths(1), 1e-15);
  EXPECT_LE(ellipsoid.measure, 1e-15);
  // The ellipsoid of a posture close by.
  const Ellipsoid beside = ellipsoid_of(model_of("planar_2r_example_7_2.toml"), {0.3, 1e-9}, 1, task);
  EXPECT_NEAR(ellipsoid.lengths(0), beside.lengths(0), 1e-9);
  EXPECT_NEAR(std::abs(ellipsoid.axes(0, 1)), std::cos(0.3), 1e-9);
}

// A pendulum's tip moves on a circle: forward by l per rad, wherever it is.
TEST(Manipulability, IsFlatWhereTheTipHasACurveToMoveOn) {
  const LoadedRobot pendulum = model_of_toml(kPendulum);
  for (const double theta : {0.0, 0.5, 1.5707963267948966}) {
    std::vector<int> task;
    const Ellipsoid ellipsoid = ellipsoid_of(pendulum, {theta}, 1, task);
    EXPECT_EQ(task, (std::vector{0, 1}));
    ASSERT_EQ(ellipsoid.lengths.size(), 1);
    EXPECT_NEAR(ellipsoid.measure, 0.5 / (2 * 0.16), 1e-14);
    EXPECT_NEAR(std::abs(ellipsoid.axes.col(0).dot(Eigen::Vector2d(-std::sin(theta), std::cos(theta)))), 1, 1e-14);
    EXPECT_NEAR(ellipsoid.centre.norm(), 0.5 * 9.81 * std::abs(std::cos(theta)) / 0.4, 1e-12);
  }
}

TEST(Manipulability, IsRefusedWhereAJointMovesNoInertia) {
  const LoadedRobot light = model_of_toml(R"(name = "light"
[[link]]
joint = "a"
mass = 1
com = [0.1, 0, 0]
[[link]]
joint = "b"
xyz = [0.5, 0, 0]
[tip]
link = "link2"
xyz = [0.5, 0, 0]
)");
  std::vector<int> task;
  EXPECT_THROW(ellipsoid_of(light, {0.3, 0.4}, 1, task), Failure);
}

TEST(Manipulability, LimitsScaleTheTorques) {
  Progress progress(true);
  const LoadedRobot panda = model_of("panda.urdf");
  Manipulability arm(panda, {TorqueNorm::limits}, progress);
  const std::vector<double> q = {0.1, -0.8, 0.3, -2.3, 0.2, 1.6, 0.8};
  const Ellipsoid ellipsoid = arm.at(q);
  const ArmPose pose(panda, q, arm.task());
  const Eigen::MatrixXd inverse = pose.J.completeOrthogonalDecomposition().pseudoInverse();
  Eigen::VectorXd tau = pose.B * inverse * ellipsoid.axes.col(0) * ellipsoid.lengths(0);
  for (Eigen::Index i = 0; i < 7; ++i) tau(i) /= i < 4 ? 87 : 12;
  EXPECT_NEAR(tau.norm(), 1, 1e-9);
  EXPECT_THROW(Manipulability(model_of("planar_2r_example_7_2.toml"), {TorqueNorm::limits}, progress), Failure);
}

TEST(Manipulability, KnowsWhereTheArmIs) {
  Progress progress(true);
  Manipulability arm(model_of("planar_2r_example_7_2.toml"), {}, progress);
  const std::vector<Eigen::Vector3d> points = arm.skeleton({0.5, 1.0});
  ASSERT_EQ(points.size(), 3U);
  EXPECT_LE((points[1] - Eigen::Vector3d(std::cos(0.5), std::sin(0.5), 0)).norm(), 1e-15);
  EXPECT_LE((points[2] - points[1] - Eigen::Vector3d(std::cos(1.5), std::sin(1.5), 0)).norm(), 1e-15);
}

TEST(Manipulability, KnowsWhereATipIsThatIsNoLinksFrame) {
  Progress progress(true);
  Manipulability arm(model_of_toml(kPendulum), {}, progress);
  const std::vector<Eigen::Vector3d> points = arm.skeleton({0.5});
  ASSERT_EQ(points.size(), 3U);
  EXPECT_EQ(points[1], Eigen::Vector3d::Zero());
  EXPECT_LE((points[2] - 0.5 * Eigen::Vector3d(std::cos(0.5), std::sin(0.5), 0)).norm(), 1e-15);
}

// The outline contains all projected points of the ellipsoid, and touches some.
TEST(Shadow, IsTheOutline) {
  srand(7);
  for (int trial = 0; trial < 20; ++trial) {
    const Eigen::Matrix3d axes = Eigen::Quaterniond::UnitRandom().toRotationMatrix();
    const Ellipsoid ellipsoid{Eigen::Vector3d::Zero(), axes, Eigen::Vector3d(3, 2, trial % 3), 0};
    const Eigen::MatrixXd onto = Eigen::Quaterniond::UnitRandom().toRotationMatrix().topRows<2>();
    const Eigen::Matrix2d half = projected_axes(ellipsoid, onto);
    EXPECT_NEAR(half.col(0).dot(half.col(1)), 0, 1e-12);
    double farthest = 0;
    for (int k = 0; k < 20000; ++k) {
      const Eigen::Vector3d u = Eigen::Vector3d::Random().normalized();
      const Eigen::Vector2d seen = onto * (axes * u.cwiseProduct(ellipsoid.lengths));
      farthest = std::max(farthest, (half.inverse() * seen).norm());
    }
    EXPECT_LE(farthest, 1 + 1e-9);
    EXPECT_GT(farthest, 0.995);
  }
}

}  // namespace
}  // namespace flatdyn
