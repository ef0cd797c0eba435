// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/trajectory/tip_kinematics.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <filesystem>

#include "functions/load/load_robot.hpp"

namespace flatdyn {
namespace {

class TipWithBall : public ::testing::Test {
 protected:
  TipWithBall() { q << 0.2, 0.4, 0.7, 0.1, 0.7, 0.1, 0.3, 0.02; }

  // waist, shoulder, the wrist's quaternion, which is a unit one, knuckle, slide.
  Eigen::VectorXd q = Eigen::VectorXd(8);
  TipKinematics tip{
      load_robot(std::filesystem::path(FLATDYN_SOURCE_DIR) / "docs" / "examples" / "ball_wrist.toml", {}).robot};
};

TEST_F(TipWithBall, MovesAlongTheColumnsOfTheJacobian) {
  constexpr double kStep = 1e-6;
  const Eigen::MatrixXd J = tip.jacobian(q, 6);
  ASSERT_EQ(J.cols(), 7);
  const auto here = tip.pose(q);
  for (Eigen::Index k = 0; k < J.cols(); ++k) {
    const auto there = tip.pose(tip.moved(q, kStep * Eigen::VectorXd::Unit(7, k)));
    const Eigen::AngleAxisd turn(Eigen::Matrix3d(there.R * here.R.transpose()));
    Eigen::VectorXd twist(6);
    twist << (there.p - here.p) / kStep, turn.angle() / kStep * turn.axis();
    EXPECT_LE((twist - J.col(k)).norm(), 1e-5) << k;
  }
}

TEST_F(TipWithBall, TurnsTheQuaternionAsAWhole) {
  const Eigen::Quaterniond before(q[2], q[3], q[4], q[5]);
  Eigen::VectorXd step = Eigen::VectorXd::Zero(7);
  step.segment<3>(2) << 0.3, -1.1, 0.7;
  const Eigen::VectorXd moved = tip.moved(q, step);
  const Eigen::Quaterniond after(moved[2], moved[3], moved[4], moved[5]);
  const Eigen::Vector3d turn = step.segment<3>(2);
  EXPECT_LE(((before.conjugate() * after).coeffs() -
             Eigen::Quaterniond(Eigen::AngleAxisd(turn.norm(), turn.normalized())).coeffs())
                .norm(),
            1e-15);
  EXPECT_EQ(moved.head<2>(), q.head<2>());
  EXPECT_EQ(moved.tail<2>(), q.tail<2>());
  EXPECT_LE((tip.moved(q, Eigen::VectorXd::Zero(7)) - q).norm(), 1e-15);
}

// The tip and its orientation, from a posture that is far from one that has them.
TEST_F(TipWithBall, FindsAPostureForAPlace) {
  Eigen::VectorXd step(7);
  step << 0.3, -0.2, 0.5, -0.4, 0.6, 0.4, 0.03;
  const auto goal = tip.pose(tip.moved(q, step));
  const Eigen::VectorXd found = inverse_kinematics(tip, {goal.p, goal.R}, q);
  EXPECT_LE((tip.pose(found).p - goal.p).norm(), 1e-9);
  EXPECT_LE((tip.pose(found).R - goal.R).norm(), 1e-8);
  EXPECT_NEAR(found.segment<4>(2).norm(), 1, 1e-14);
}

}  // namespace
}  // namespace flatdyn
