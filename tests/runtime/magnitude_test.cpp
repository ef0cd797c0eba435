// SPDX-License-Identifier: GPL-2.0-or-later
// A magnitude bounds its value, equals it if no terms cancel, and is zero only if the value is always zero.
#include "truth/reference/magnitude.hpp"

#include <gtest/gtest.h>

#include "support/reference_robots.hpp"

namespace flatdyn {
namespace {

namespace ref = reference;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using testing::random_reference_robot;
using testing::ReferenceState;

// The bound itself is rounded, too.
constexpr double kSlack = 1 + 1e-12;

void expect_bounded(const MatrixXd& value, const MatrixXd& magnitude, const char* what) {
  ASSERT_EQ(value.rows(), magnitude.rows());
  ASSERT_EQ(value.cols(), magnitude.cols());
  for (Eigen::Index i = 0; i < value.rows(); ++i) {
    for (Eigen::Index j = 0; j < value.cols(); ++j) {
      EXPECT_LE(std::abs(value(i, j)), kSlack * magnitude(i, j)) << what << " " << i << "," << j;
    }
  }
}

class Magnitudes : public ::testing::TestWithParam<unsigned> {
 protected:
  ref::Robot<double> robot = random_reference_robot<double>(GetParam(), {.joints = 8});
  int n = robot.size();
  ReferenceState<double> s{GetParam(), n};
  VectorXd zero = VectorXd::Zero(n);
};

TEST_P(Magnitudes, BoundTheTorques) {
  expect_bounded(ref::inverse_dynamics(robot, s.q, s.qd, s.qdd), ref::torque_magnitude(robot, s.q, s.qd, s.qdd), "tau");
  expect_bounded(ref::bias(robot, s.q, s.qd), ref::torque_magnitude(robot, s.q, s.qd, zero), "bias");
  expect_bounded(ref::gravity(robot, s.q), ref::torque_magnitude(robot, s.q, zero, zero), "g");
  const ref::MagnitudeOptions tip{.f_e = s.h_e.f_e.norm(), .mu_e = s.h_e.mu_e.norm()};
  expect_bounded(ref::inverse_dynamics(robot, s.q, s.qd, s.qdd, s.h_e),
                 ref::torque_magnitude(robot, s.q, s.qd, s.qdd, tip), "tau with tip force");
}

TEST_P(Magnitudes, BoundTheMatrices) {
  expect_bounded(ref::inertia_matrix(robot, s.q), ref::inertia_magnitude(robot, s.q), "B");
  expect_bounded(ref::christoffel(robot, s.q), ref::christoffel_magnitude(robot, s.q), "c");
  expect_bounded(ref::coriolis_matrix(robot, s.q, s.qd), ref::coriolis_magnitude(robot, s.q, s.qd), "C");
}

TEST_P(Magnitudes, BoundTheTipAndThePotentialEnergy) {
  EXPECT_LE(ref::tip_pose(robot, s.q).p.norm(), kSlack * ref::reach(robot, s.q));
  EXPECT_LE(std::abs(ref::potential_energy(robot, s.q)), kSlack * ref::potential_magnitude(robot, s.q));
  const VectorXd a = ref::jacobian_dot_qd(robot, s.q, s.qd);
  const Eigen::Vector2d bound = ref::tip_acceleration_magnitude(robot, s.q, s.qd);
  EXPECT_LE(a.head(3).norm(), kSlack * bound[0]);
  EXPECT_LE(a.tail(3).norm(), kSlack * bound[1]);
}

// A scale that is far too large would hide errors: over many states the largest torque reaches its magnitude up to a
// factor that grows only with the number of links.
TEST_P(Magnitudes, AreNotMuchLargerThanTheTorquesCanBe) {
  VectorXd largest = VectorXd::Zero(n);
  for (unsigned k = 0; k < 300; ++k) {
    const ReferenceState<double> state(k, n);
    const VectorXd ratio = ref::inverse_dynamics(robot, state.q, state.qd, state.qdd)
                               .cwiseAbs()
                               .cwiseQuotient(ref::torque_magnitude(robot, state.q, state.qd, state.qdd));
    largest = largest.cwiseMax(ratio);
  }
  EXPECT_GE(largest.minCoeff(), 0.01) << largest.transpose();
}

INSTANTIATE_TEST_SUITE_P(Seeds, Magnitudes, ::testing::Range(1u, 21u));

// A point on a stretched arm: every term has the same direction, so nothing cancels.
TEST(Magnitude, IsAttainedWhereNothingCancels) {
  ref::Robot<double> robot;
  robot.links.resize(2);
  robot.gravity = {0, -9.81, 0};
  robot.tip = 1;
  ref::Joint<double> joint;
  joint.type = ref::JointType::revolute;
  joint.index = 0;
  joint.child = 1;
  joint.viscous = 0.5;
  joint.coulomb = 0.25;
  robot.joints = {joint};
  robot.links[1].inertials = {{2.0, {0.5, 0, 0}, ref::Matrix3<double>::Zero()}};
  const VectorXd q = VectorXd::Zero(1), qdd = VectorXd::Constant(1, 3);
  const double tau = ref::inverse_dynamics(robot, q, VectorXd(VectorXd::Zero(1)), qdd)[0];
  EXPECT_DOUBLE_EQ(tau, 2 * 0.5 * (0.5 * 3 + 9.81));
  EXPECT_DOUBLE_EQ(ref::torque_magnitude(robot, q, VectorXd::Zero(1), qdd)[0], tau);
}

// The acceleration of one branch has no effect on the other, and the magnitude says so: not even rounding may appear
// there.
TEST(Magnitude, IsZeroBetweenBranches) {
  ref::Robot<double> robot = random_reference_robot<double>(3, {.joints = 2, .chain = true, .rotors = false});
  ASSERT_EQ(robot.size(), 2);
  robot.joints[1].parent = 0;
  const MatrixXd magnitude = ref::inertia_magnitude(robot, ReferenceState<double>(1, 2).q);
  EXPECT_EQ(magnitude(0, 1), 0);
  EXPECT_EQ(magnitude(1, 0), 0);
  EXPECT_GT(magnitude(0, 0), 0);
}

}  // namespace
}  // namespace flatdyn
