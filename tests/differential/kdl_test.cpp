// SPDX-License-Identifier: GPL-2.0-or-later
// The reference, in 50 digits, against the Orocos Kinematics and Dynamics Library on random robots. KDL computes in
// double; it has no rotors (its joints' inertia is our armature), its solvers have no friction, and gravity acts at the
// base. Errors are measured on the scale of the quantity's own terms.
#include <gtest/gtest.h>

#include <kdl/chaindynparam.hpp>
#include <kdl/chainfdsolver_recursive_newton_euler.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainidsolver_recursive_newton_euler.hpp>
#include <kdl/chainjnttojacdotsolver.hpp>
#include <kdl/chainjnttojacsolver.hpp>
#include <kdl/tree.hpp>
#include <kdl/treeidsolver_recursive_newton_euler.hpp>

#include "support/kdl_chain.hpp"
#include "support/reference_robots.hpp"
#include "truth/reference/magnitude.hpp"

namespace flatdyn {
namespace {

namespace ref = reference;
using S = testing::Digits50;
using Vector = ref::VectorX<double>;
using Matrix = ref::MatrixX<double>;
using testing::kdl;
using testing::kdl_chain;
using testing::random_reference_robot;
using testing::ReferenceState;

constexpr double kBound = 64;  // scaled error allowed for KDL's own rounding
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

// Each entry within kBound units of the last place of its magnitude.
void expect_close(const Matrix& value, const ref::MatrixX<S>& exact, const Matrix& magnitude, const char* what) {
  ASSERT_EQ(value.rows(), exact.rows()) << what;
  ASSERT_EQ(value.cols(), exact.cols()) << what;
  for (Eigen::Index i = 0; i < value.rows(); ++i) {
    for (Eigen::Index j = 0; j < value.cols(); ++j) {
      const double error = S(abs(S(value(i, j)) - exact(i, j))).convert_to<double>();
      EXPECT_LE(error, kBound * kEpsilon * magnitude(i, j)) << what << " " << i << "," << j << ": " << value(i, j);
    }
  }
}

class Kdl : public ::testing::TestWithParam<unsigned> {
 protected:
  explicit Kdl(bool chain = true) : options{.joints = 9, .chain = chain, .rotors = false, .friction = false} {}

  testing::RandomRobot options;
  ref::Robot<S> exact = random_reference_robot<S>(GetParam(), options);
  ref::Robot<double> robot = random_reference_robot<double>(GetParam(), options);
  int n = robot.size();
  unsigned joints = static_cast<unsigned>(n);
  ReferenceState<double> s{GetParam(), n};
  ReferenceState<S> x{GetParam(), n};
  Vector zero = Vector::Zero(n);
};

class KdlChain : public Kdl {
 protected:
  KDL::Chain chain = kdl_chain(robot);
};

TEST_P(KdlChain, InverseDynamics) {
  KDL::ChainIdSolver_RNE solver(chain, kdl(robot.gravity));
  KDL::JntArray tau(joints);
  const KDL::Wrenches none(chain.getNrOfSegments(), KDL::Wrench::Zero());
  ASSERT_EQ(solver.CartToJnt(kdl(s.q), kdl(s.qd), kdl(s.qdd), none, tau), 0);
  expect_close(tau.data, ref::inverse_dynamics(exact, x.q, x.qd, x.qdd), ref::torque_magnitude(robot, s.q, s.qd, s.qdd),
               "tau");
}

// KDL expects the wrench that acts on the segment, in the segment's axes: the reversed wrench of the tip.
TEST_P(KdlChain, TipForce) {
  KDL::ChainIdSolver_RNE solver(chain, kdl(robot.gravity));
  KDL::JntArray tau(joints);
  KDL::Wrenches wrenches(chain.getNrOfSegments(), KDL::Wrench::Zero());
  const ref::Matrix3<double> R = ref::tip_pose(robot, s.q).R;
  const ref::Vector3<double> f = R.transpose() * s.h_e.f_e, mu = R.transpose() * s.h_e.mu_e;
  wrenches.back() = -KDL::Wrench(kdl(f), kdl(mu));
  ASSERT_EQ(solver.CartToJnt(kdl(s.q), kdl(s.qd), kdl(s.qdd), wrenches, tau), 0);
  const ref::MagnitudeOptions tip{.f_e = s.h_e.f_e.norm(), .mu_e = s.h_e.mu_e.norm()};
  expect_close(tau.data, ref::inverse_dynamics(exact, x.q, x.qd, x.qdd, x.h_e),
               ref::torque_magnitude(robot, s.q, s.qd, s.qdd, tip), "tau");
}

TEST_P(KdlChain, InertiaCoriolisAndGravity) {
  KDL::ChainDynParam solver(chain, kdl(robot.gravity));
  KDL::JntSpaceInertiaMatrix B(static_cast<int>(joints));
  KDL::JntArray velocity_torque(joints), g(joints);
  ASSERT_EQ(solver.JntToMass(kdl(s.q), B), 0);
  ASSERT_EQ(solver.JntToCoriolis(kdl(s.q), kdl(s.qd), velocity_torque), 0);
  ASSERT_EQ(solver.JntToGravity(kdl(s.q), g), 0);
  expect_close(B.data, ref::inertia_matrix(exact, x.q), ref::inertia_magnitude(robot, s.q), "B");
  expect_close(g.data, ref::gravity(exact, x.q), ref::torque_magnitude(robot, s.q, zero, zero), "g");
  const ref::VectorX<S> expected = ref::coriolis_matrix(exact, x.q, x.qd) * x.qd;
  expect_close(velocity_torque.data, expected, ref::torque_magnitude(robot, s.q, s.qd, zero, {.gravity = false}),
               "C qd");
}

TEST_P(KdlChain, ForwardDynamics) {
  KDL::ChainFdSolver_RNE solver(chain, kdl(robot.gravity));
  KDL::JntArray qdd(joints);
  const KDL::Wrenches none(chain.getNrOfSegments(), KDL::Wrench::Zero());
  ASSERT_EQ(solver.CartToJnt(kdl(s.q), kdl(s.qd), kdl(s.tau), none, qdd), 0);
  const Vector terms = ref::torque_magnitude(robot, s.q, s.qd, zero) + s.tau.cwiseAbs() +
                       ref::inertia_magnitude(robot, s.q) * qdd.data.cwiseAbs();
  const Vector magnitude = ref::inertia_matrix(robot, s.q).inverse().cwiseAbs() * terms;
  expect_close(qdd.data, ref::forward_dynamics(exact, x.q, x.qd, x.tau), magnitude, "qdd");
}

TEST_P(KdlChain, Kinematics) {
  const double reach = ref::reach(robot, s.q);
  KDL::Frame pose;
  KDL::ChainFkSolverPos_recursive positions(chain);
  ASSERT_EQ(positions.JntToCart(kdl(s.q), pose), 0);
  const ref::Pose<S> tip = ref::tip_pose(exact, x.q);
  for (int i = 0; i < 3; ++i) {
    EXPECT_LE(abs(S(S(pose.p[i]) - tip.p[i])), S(kBound * kEpsilon * reach));
    for (int j = 0; j < 3; ++j) EXPECT_LE(abs(S(S(pose.M(i, j)) - tip.R(i, j))), S(kBound * kEpsilon));
  }
  KDL::ChainJntToJacSolver jacobians(chain);
  KDL::Jacobian J(joints);
  ASSERT_EQ(jacobians.JntToJac(kdl(s.q), J), 0);
  const Matrix lengths = Matrix::Constant(6, n, std::max(1.0, reach));
  expect_close(J.data, ref::jacobian(exact, x.q), lengths, "J");
}

TEST_P(KdlChain, JacobianDotTimesSpeed) {
  KDL::ChainJntToJacDotSolver solver(chain);
  solver.setHybridRepresentation();
  KDL::Twist twist;
  ASSERT_EQ(solver.JntToJacDot(KDL::JntArrayVel(kdl(s.q), kdl(s.qd)), twist), 0);
  Vector rate(6);
  for (int i = 0; i < 6; ++i) rate[i] = twist(i);
  const Eigen::Vector2d size = ref::tip_acceleration_magnitude(robot, s.q, s.qd);
  Vector magnitude(6);
  magnitude << Vector::Constant(3, size[0]), Vector::Constant(3, size[1]);
  expect_close(rate, ref::jacobian_dot_qd(exact, x.q, x.qd), magnitude, "Jdot qd");
}

INSTANTIATE_TEST_SUITE_P(Seeds, KdlChain, ::testing::Range(1u, 31u));

class KdlTree : public Kdl {
 protected:
  KdlTree() : Kdl(false) {}
};

TEST_P(KdlTree, InverseDynamics) {
  KDL::Tree tree("link0");
  for (const auto& joint : robot.joints) {
    std::string hook = "link" + std::to_string(joint.parent);
    for (const auto& segment : testing::segments(robot, joint)) {
      ASSERT_TRUE(tree.addSegment(segment, hook));
      hook = segment.getName();
    }
  }
  ASSERT_EQ(tree.getNrOfJoints(), joints);
  // Joints were added in the order of q, and KDL numbers them in that order.
  KDL::TreeIdSolver_RNE solver(tree, kdl(robot.gravity));
  KDL::JntArray tau(joints);
  ASSERT_EQ(solver.CartToJnt(kdl(s.q), kdl(s.qd), kdl(s.qdd), KDL::WrenchMap(), tau), 0);
  expect_close(tau.data, ref::inverse_dynamics(exact, x.q, x.qd, x.qdd), ref::torque_magnitude(robot, s.q, s.qd, s.qdd),
               "tau");
}

INSTANTIATE_TEST_SUITE_P(Seeds, KdlTree, ::testing::Range(1u, 31u));

}  // namespace
}  // namespace flatdyn
