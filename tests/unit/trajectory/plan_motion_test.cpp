// SPDX-License-Identifier: GPL-2.0-or-later
// Planned motions: the tip's places, and consistency of positions, rates and accelerations.
#include "laboratory/trajectory/plan_motion.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "laboratory/trajectory/tip_line.hpp"
#include "support/robot_models.hpp"

namespace flatdyn {
namespace {

using testing::model_of;

PlacedProfile profile(VelocityShape shape, std::map<std::string, std::vector<double>> given) {
  return {shape, std::move(given), {}, {}};
}

Eigen::VectorXd vector(const std::vector<double>& v) {
  return Eigen::Map<const Eigen::VectorXd>(v.data(), static_cast<Eigen::Index>(v.size()));
}

Trajectory motion_of(const TrajectoryPlan& plan, const TipKinematics& tip) {
  Diagnostics found;
  Trajectory trajectory = planned_motion(plan, tip, found);
  for (const Diagnostic& each : found.all()) ADD_FAILURE() << to_string(each);
  return trajectory;
}

// Compares q̇ with differences of q, and q̈ with those of q̇, except where an acceleration jumps.
void expect_derivatives(const Trajectory& trajectory, double rate_error, double acceleration_error, double jump) {
  const auto& p = trajectory.points;
  for (std::size_t k = 1; k + 1 < p.size(); ++k) {
    const double h = p[k + 1].time - p[k - 1].time;
    if (p[k + 1].time - p[k].time < h / 3) continue;  // the last step is shorter
    for (std::size_t i = 0; i < p[k].q.size(); ++i) {
      const bool jumps =
          std::abs(p[k + 1].qdd[i] - p[k].qdd[i]) > jump || std::abs(p[k].qdd[i] - p[k - 1].qdd[i]) > jump;
      if (jumps) continue;
      EXPECT_NEAR((p[k + 1].q[i] - p[k - 1].q[i]) / h, p[k].qd[i], rate_error) << p[k].time << " joint " << i;
      EXPECT_NEAR((p[k + 1].qd[i] - p[k - 1].qd[i]) / h, p[k].qdd[i], acceleration_error)
          << p[k].time << " joint " << i;
    }
  }
}

class LineOf : public ::testing::Test {
 protected:
  // Checks that the tip is on the line with the speed and acceleration of the profile: J q̇ and J q̈ + J̇ q̇.
  static void expect_line(const Trajectory& trajectory, const TipKinematics& tip, const VelocityProfile& way,
                          const Eigen::Vector3d& from, const Eigen::Vector3d& u, int rows) {
    const Eigen::Matrix3d R = tip.pose(vector(trajectory.points[0].q)).R;
    for (const TrajectoryPoint& point : trajectory.points) {
      const Progression here = way.at(point.time, point.time < way.duration() ? Side::after : Side::before);
      const Eigen::VectorXd q = vector(point.q), qd = vector(point.qd), qdd = vector(point.qdd);
      EXPECT_LT((tip.pose(q).p - from - here.position * u).norm(), 1e-9) << point.time;
      if (rows == 6) {
        EXPECT_LT((tip.pose(q).R - R).norm(), 1e-9) << point.time;
      }
      Eigen::VectorXd v = tip.jacobian(q, rows) * qd;
      Eigen::VectorXd a = tip.jacobian(q, rows) * qdd + reference::jacobian_dot_qd(tip.robot(), q, qd).topRows(rows);
      v.head<3>() -= here.speed * u;
      a.head<3>() -= here.acceleration * u;
      EXPECT_LT(v.norm(), 1e-9) << point.time;
      EXPECT_LT(a.norm(), 1e-8) << point.time;
    }
  }
};

// Example 7.2, Fig. 7.9 and 7.10.
TEST_F(LineOf, ThePlanarArm) {
  const TipKinematics tip(model_of("planar_2r_example_7_2.toml").robot);
  TrajectoryPlan plan;
  plan.start = TipPosture{{0.2, 0, 0}, Elbow::down, {}, {}};
  const auto shape = VelocityShape::trapezoidal;
  plan.segments.push_back(
      {LineMove{{1.6, 0, 0}, true, false, profile(shape, {{"speed", {5}}, {"acceleration_time", {0.15}}})}, {}});
  const Trajectory trajectory = motion_of(plan, tip);
  const VelocityProfile way(1.6, {shape, {}, {}, 5, 0.15});
  EXPECT_NEAR(trajectory.duration(), 0.47, 1e-12);
  EXPECT_EQ(trajectory.points.size(), 471u);
  expect_line(trajectory, tip, way, {0.2, 0, 0}, Eigen::Vector3d::UnitX(), 3);
  expect_derivatives(trajectory, 1e-3, 3e-2, 1);
  // cos ϑ_2 = (r² − 2) / 2 with both links of 1 m.
  EXPECT_NEAR(trajectory.points.front().q[1], std::acos((0.04 - 2) / 2), 1e-12);
  EXPECT_NEAR(trajectory.points.front().q[0], -std::acos(0.1), 1e-12);
  EXPECT_NEAR(trajectory.points.back().q[1], std::acos((3.24 - 2) / 2), 1e-12);
}

// Seven joints for three or six directions: q̈ is the derivative of the smallest rates, not the smallest acceleration.
TEST_F(LineOf, ARedundantArmWithAndWithoutItsOrientation) {
  const TipKinematics tip(model_of("panda.urdf").robot);
  const std::vector<double> start = {0.1, -0.6, 0.2, -2.1, 0.1, 1.6, 0.7};
  const Eigen::Vector3d by(0.1, 0.25, -0.2), from = tip.pose(vector(start)).p;
  for (const bool held : {false, true}) {
    TrajectoryPlan plan;
    plan.rate = 2000;
    plan.start = JointPosture(start.begin(), start.end());
    plan.segments.push_back({LineMove{by, true, held, profile(VelocityShape::triangular, {{"duration", {0.8}}})}, {}});
    const Trajectory trajectory = motion_of(plan, tip);
    expect_line(trajectory, tip, {by.norm(), {VelocityShape::triangular, 0.8, {}, {}, {}}}, from, by.normalized(),
                held ? 6 : 3);
    expect_derivatives(trajectory, 1e-5, 1e-4, 0.05);
  }
}

TEST(PlannedMotion, GoesFromSegmentToSegmentAndWaits) {
  const TipKinematics tip(model_of("planar_2r_example_7_2.toml").robot);
  TrajectoryPlan plan;
  plan.rate = 100;
  plan.start = JointPosture{0.5, std::nullopt};
  const auto triangle = [](double duration) {
    return profile(VelocityShape::triangular, {{"duration", {duration, 2 * duration}}});
  };
  plan.segments.push_back({JointMove{JointPosture{1.0, 1.0}, true, triangle(0.5)}, {}});
  plan.segments.push_back({Dwell{0.25}, {}});
  plan.segments.push_back({JointMove{JointPosture{std::nullopt, 0.25}, false, triangle(0.5)}, {}});
  const Trajectory trajectory = motion_of(plan, tip);
  EXPECT_NEAR(trajectory.duration(), 2.25, 1e-12);
  EXPECT_EQ(trajectory.points.size(), 226u);
  const auto q_at = [&](int k) { return trajectory.points[static_cast<std::size_t>(k)].q; };
  EXPECT_EQ(q_at(0), (std::vector<double>{0.5, 0}));
  EXPECT_NEAR(q_at(25)[0], 1.0, 1e-12);  // half the distance in half the time
  EXPECT_EQ(q_at(75)[0], 1.5);           // waits for the second joint
  EXPECT_EQ(q_at(110), (std::vector<double>{1.5, 1.0}));
  EXPECT_EQ(q_at(225), (std::vector<double>{1.5, 0.25}));
  EXPECT_LT(trajectory.points[130].qdd[1], 0);
  expect_derivatives(trajectory, 1e-9, 1e-9, 0.1);
}

// The times of jumps are samples of their own, an even number of intervals apart; rates are exactly zero at rest.
TEST(PlannedMotion, InIntervalsHasAPointAtEveryJump) {
  const TipKinematics tip(model_of("planar_2r_example_7_2.toml").robot);
  TrajectoryPlan plan;
  plan.start = JointPosture{0.5, 0.1};
  const PlacedProfile profiles =
      profile(VelocityShape::trapezoidal, {{"speed", {2, 3}}, {"acceleration_time", {0.17, 0.13}}});
  plan.segments = {{JointMove{JointPosture{1.0, 1.0}, true, profiles}, {}},
                   {Dwell{0.31}, {}},
                   {JointMove{JointPosture{-0.7, 1.1}, true, profiles}, {}}};
  Diagnostics found;
  const Trajectory trajectory = planned_motion(plan, tip, found, 100);
  EXPECT_GE(trajectory.points.size(), 101u);
  EXPECT_LE(trajectory.points.size(), 121u);
  const std::vector<double> jumps = {0.13, 0.17, 1.0 / 3, 0.5, 1.0 / 3 + 0.13, 0.67, 0.98, 0.98 + 0.13, 0.98 + 0.17};
  for (const double jump : jumps) {
    std::size_t k = 0;
    while (k < trajectory.points.size() && std::abs(trajectory.points[k].time - jump) > 1e-12) ++k;
    ASSERT_LT(k, trajectory.points.size()) << jump;
    EXPECT_EQ(k % 2, 0u) << jump;
    ASSERT_EQ(trajectory.points[k].qdd_before.size(), 2u) << jump;
    EXPECT_GT(std::abs(trajectory.points[k].qdd_before[0] - trajectory.points[k].qdd[0]) +
                  std::abs(trajectory.points[k].qdd_before[1] - trajectory.points[k].qdd[1]),
              1)
        << jump;
    for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(trajectory.points[k].qdd_before[i], trajectory.points[k - 1].qdd[i]);
  }
  for (const TrajectoryPoint& point : trajectory.points) {
    const bool waits = point.time > 0.67 - 1e-12 && point.time < 0.98 + 1e-12;
    EXPECT_EQ(waits || point.time == 0 || point.time == trajectory.duration(), point.qd == std::vector<double>(2, 0))
        << point.time;
  }
}

// At any sampling rate, a motion has its two ends.
TEST(PlannedMotion, HasItsEndsAtAnyRate) {
  const TipKinematics tip(model_of("planar_2r_example_7_2.toml").robot);
  for (const double rate : {1e-9, 1.0, 1e5}) {
    TrajectoryPlan plan;
    plan.rate = rate;
    plan.start = JointPosture{0.0, 0.0};
    plan.segments = {
        {JointMove{JointPosture{1.0, 1.0}, true, profile(VelocityShape::triangular, {{"duration", {0.01, 0.01}}})},
         {}}};
    const Trajectory trajectory = motion_of(plan, tip);
    ASSERT_GE(trajectory.points.size(), 2u);
    EXPECT_EQ(trajectory.points.back().time, 0.01);
    EXPECT_EQ(trajectory.points.back().q[0], 1.0);
    EXPECT_EQ(trajectory.points.front().qd[0], 0.0);
  }
}

// In the tip's own axes the force turns with the tip.
TEST(PlannedMotion, TurnsAForceWithTheTip) {
  const TipKinematics tip(model_of("planar_2r_example_7_2.toml").robot);
  TrajectoryPlan plan;
  plan.start = JointPosture{std::numbers::pi / 2, 0.0};
  plan.tip_force = TipForce{{10, 0, 0, 0, 0, 2}, true};
  plan.segments.push_back(
      {JointMove{JointPosture{0.0, 1.0}, true, profile(VelocityShape::triangular, {{"duration", {1, 1}}})}, {}});
  const Trajectory trajectory = motion_of(plan, tip);
  EXPECT_NEAR(trajectory.points.front().h_e[1], 10, 1e-12);
  EXPECT_NEAR(trajectory.points.back().h_e[0], 10 * std::cos(std::numbers::pi / 2 + 1), 1e-12);
  EXPECT_NEAR(trajectory.points.back().h_e[5], 2, 1e-12);
}

TEST(InverseKinematics, FindsWhatForwardKinematicsGave) {
  const TipKinematics tip(model_of("panda.urdf").robot);
  const Eigen::VectorXd q = vector({0.3, -0.4, 0.2, -1.9, 0.1, 1.6, 0.7});
  const reference::Pose<double> pose = tip.pose(q);
  const Eigen::VectorXd found = inverse_kinematics(tip, {pose.p, pose.R}, vector({0, 0, 0, -1.5, 0, 1.5, 0}));
  EXPECT_LT((tip.pose(found).p - pose.p).norm(), 1e-9);
  EXPECT_LT((tip.pose(found).R - pose.R).norm(), 1e-9);
  EXPECT_THROW(inverse_kinematics(tip, {{2, 0, 0}, {}}, q), Unreachable);
}

TEST(TwoLinkArm, HasBothElbows) {
  const TipKinematics tip(model_of("planar_2r_example_7_2.toml").robot);
  const std::optional<TwoLinkArm> arm = TwoLinkArm::of(tip);
  ASSERT_TRUE(arm);
  for (const Eigen::Vector3d& p :
       {Eigen::Vector3d(0.2, 0, 0), Eigen::Vector3d(-1, 1.1, 0), Eigen::Vector3d(0, -2, 0)}) {
    for (const Elbow elbow : {Elbow::down, Elbow::up}) {
      const Eigen::VectorXd q = arm->positions(p, elbow);
      EXPECT_LT((tip.pose(q).p - p).norm(), 1e-12);
      EXPECT_TRUE(std::sin(q[1]) == 0 || (q[1] > 0) == (elbow == Elbow::down));
    }
  }
  EXPECT_FALSE(TwoLinkArm::of(TipKinematics(model_of("panda.urdf").robot)));
  EXPECT_FALSE(TwoLinkArm::of(TipKinematics(model_of("ur5.urdf").robot)));
}

}  // namespace
}  // namespace flatdyn
