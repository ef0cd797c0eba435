// SPDX-License-Identifier: GPL-2.0-or-later
// The reference against the textbook's closed formulas, in 50 digits, with generic numbers.
#include <gtest/gtest.h>

#include "support/reference_robots.hpp"

namespace flatdyn {
namespace {

namespace ref = reference;
using S = testing::Digits50;
using Vector = ref::VectorX<S>;
using Matrix = ref::MatrixX<S>;

const S kTolerance("1e-48");

void expect_near(const Matrix& value, const Matrix& expected, const char* what) {
  ASSERT_EQ(value.rows(), expected.rows());
  ASSERT_EQ(value.cols(), expected.cols());
  EXPECT_LE(Matrix(value - expected).cwiseAbs().maxCoeff(), kTolerance) << what << ":\n"
                                                                        << value << "\nnot\n"
                                                                        << expected;
}

Vector two(const S& a, const S& b) {
  Vector v(2);
  v << a, b;
  return v;
}

Matrix square(const S& a, const S& b, const S& c, const S& d) {
  Matrix m(2, 2);
  m << a, b, c, d;
  return m;
}

ref::Joint<S> joint(ref::JointType type, int index, const ref::Rotor<S>& rotor) {
  ref::Joint<S> result;
  result.type = type;
  result.index = index;
  result.parent = index;
  result.child = index + 1;
  result.rotor = rotor;
  return result;
}

ref::Inertial<S> point(const S& mass, const ref::Vector3<S>& r) { return {mass, r, ref::Matrix3<S>::Zero()}; }

// A body whose inertia about x and y is arbitrary, since it must not matter in the plane.
ref::Inertial<S> plane_body(const S& mass, const S& x, const S& I_zz) {
  return {mass, {x, S(0), S(0)}, ref::Vector3<S>(S("0.7"), S("0.9"), I_zz).asDiagonal()};
}

// Example 7.1: (I + I_m k_r²) θ̈ + (F + F_m k_r²) θ̇ + m g l sin θ = τ, θ from the hanging position.
TEST(Textbook, PendulumWithMotor) {
  const S I("0.31"), I_m("0.0021"), k_r("57"), F("0.4"), F_m("0.0003"), m("1.7"), g("9.81"), l("0.6");
  ref::Robot<S> robot;
  robot.links.resize(2);
  robot.gravity = {g, S(0), S(0)};
  ref::Joint<S> theta = joint(ref::JointType::revolute, 0, {0, k_r, I_m, ref::Vector3<S>::UnitZ()});
  theta.viscous = F + F_m * k_r * k_r;
  robot.joints = {theta};
  robot.links[1].inertials = {plane_body(m, l, I - m * l * l)};
  robot.tip = 1;

  const Vector q = Vector::Constant(1, S("0.83")), qd = Vector::Constant(1, S("-2.1")),
               qdd = Vector::Constant(1, S("3.7"));
  const Vector tau =
      Vector::Constant(1, S((I + I_m * k_r * k_r) * qdd[0] + (F + F_m * k_r * k_r) * qd[0] + m * g * l * sin(q[0])));
  expect_near(ref::inverse_dynamics(robot, q, qd, qdd), tau, "tau");
  expect_near(ref::forward_dynamics(robot, q, qd, tau), qdd, "qdd");
  EXPECT_LE(abs(S(ref::potential_energy(robot, q) + m * g * l * cos(q[0]))), kTolerance);
  EXPECT_LE(abs(S(ref::kinetic_energy(robot, q, qd) - (I + I_m * k_r * k_r) * qd[0] * qd[0] / 2)), kTolerance);
}

// Sect. 7.3.1: each motor is at the origin of the frame before its joint.
TEST(Textbook, TwoLinkCartesianArm) {
  const S m_l1("3.1"), m_l2("2.3"), m_m1("0.9"), m_m2("0.8"), I_m1("0.01"), I_m2("0.02"), k_r1("31"), k_r2("-17"),
      g("9.81");
  const ref::Vector3<S> x = ref::Vector3<S>::UnitX(), z = ref::Vector3<S>::UnitZ();
  ref::Robot<S> robot;
  robot.links.resize(3);
  robot.gravity = -g * z;
  robot.joints = {joint(ref::JointType::prismatic, 0, {0, k_r1, I_m1, z}),
                  joint(ref::JointType::prismatic, 1, {1, k_r2, I_m2, x})};
  robot.joints[1].axis = x;
  robot.links[0].inertials = {point(m_m1, {S(0), S(0), S(0)})};
  robot.links[1].inertials = {point(m_l1, {S("0.1"), S("0.2"), S("0.3")}), point(m_m2, {S(0), S(0), S(0)})};
  robot.links[2].inertials = {point(m_l2, {S("0.3"), S("-0.2"), S("0.1")})};
  robot.tip = 2;

  const Vector q = two(S("0.4"), S("0.7")), qd = two(S("-1.3"), S("2.2"));
  const Matrix B = square(m_l1 + m_m2 + k_r1 * k_r1 * I_m1 + m_l2, S(0), S(0), m_l2 + k_r2 * k_r2 * I_m2);
  expect_near(ref::inertia_matrix(robot, q), B, "B");
  expect_near(ref::gravity(robot, q), two((m_l1 + m_m2 + m_l2) * g, S(0)), "g");
  expect_near(ref::coriolis_matrix(robot, q, qd), Matrix::Zero(2, 2), "C");
  Matrix J = Matrix::Zero(6, 2);
  J(2, 0) = J(0, 1) = S(1);
  expect_near(ref::jacobian(robot, q), J, "J");
}

class PlanarArm : public ::testing::Test {
 protected:
  PlanarArm() {
    const ref::Vector3<S> z = ref::Vector3<S>::UnitZ();
    robot.links.resize(3);
    robot.gravity = {S(0), -g, S(0)};
    // Standard DH as in Fig. 7.4: each link's frame is at its end.
    robot.joints = {joint(ref::JointType::revolute, 0, {0, k_r1, I_m1, z}),
                    joint(ref::JointType::revolute, 1, {1, k_r2, I_m2, z})};
    robot.joints[0].p_1 = {a_1, S(0), S(0)};
    robot.joints[1].p_1 = {a_2, S(0), S(0)};
    const ref::Matrix3<S> rotor_2 = ref::Vector3<S>(S("0.3"), S("0.3"), I_m2).asDiagonal();
    robot.links[0].inertials = {point(m_m1, {S(0), S(0), S(0)})};
    robot.links[1].inertials = {plane_body(m_l1, l_1 - a_1, I_l1), {m_m2, {S(0), S(0), S(0)}, rotor_2}};
    robot.links[2].inertials = {plane_body(m_l2, l_2 - a_2, I_l2)};
    robot.tip = 2;
  }

  Matrix B() const {
    const S b_12 = I_l2 + m_l2 * (l_2 * l_2 + a_1 * l_2 * cos(q[1])) + k_r2 * I_m2;
    const S b_11 = I_l1 + m_l1 * l_1 * l_1 + k_r1 * k_r1 * I_m1 + I_l2 +
                   m_l2 * (a_1 * a_1 + l_2 * l_2 + 2 * a_1 * l_2 * cos(q[1])) + I_m2 + m_m2 * a_1 * a_1;
    return square(b_11, b_12, b_12, I_l2 + m_l2 * l_2 * l_2 + k_r2 * k_r2 * I_m2);
  }
  Vector gravity() const {
    const S c_1 = cos(q[0]), c_12 = cos(S(q[0] + q[1]));
    return two((m_l1 * l_1 + m_m2 * a_1 + m_l2 * a_1) * g * c_1 + m_l2 * l_2 * g * c_12, m_l2 * l_2 * g * c_12);
  }
  S h() const { return -m_l2 * a_1 * l_2 * sin(q[1]); }
  Matrix C() const { return square(h() * qd[1], h() * (qd[0] + qd[1]), -h() * qd[0], S(0)); }

  const S a_1{"0.9"}, a_2{"0.7"}, l_1{"0.4"}, l_2{"0.37"}, m_l1{"5.1"}, m_l2{"4.3"}, I_l1{"0.41"}, I_l2{"0.29"};
  const S m_m1{"0.5"}, m_m2{"0.45"}, I_m1{"0.011"}, I_m2{"0.013"}, k_r1{"90"}, k_r2{"-70"}, g{"9.81"};
  const Vector q = two(S("0.63"), S("-1.27")), qd = two(S("1.9"), S("-2.4")), qdd = two(S("3.1"), S("5.3"));
  ref::Robot<S> robot;
};

TEST_F(PlanarArm, InertiaMatrix) { expect_near(ref::inertia_matrix(robot, q), B(), "B"); }

TEST_F(PlanarArm, Gravity) { expect_near(ref::gravity(robot, q), gravity(), "g"); }

// The columns for 11, 12 and 22 of c_ijk.
TEST_F(PlanarArm, ChristoffelSymbols) {
  Matrix c(2, 3);
  c << S(0), h(), h(), -h(), S(0), S(0);
  expect_near(ref::christoffel(robot, q), c, "c_ijk");
  expect_near(ref::coriolis_matrix(robot, q, qd), C(), "C");
}

TEST_F(PlanarArm, EquationsOfMotion) {
  const Vector tau = B() * qdd + C() * qd + gravity();
  expect_near(ref::inverse_dynamics(robot, q, qd, qdd), tau, "(7.82)");
  expect_near(ref::bias(robot, q, qd), Vector(C() * qd + gravity()), "bias");
  expect_near(ref::forward_dynamics(robot, q, qd, tau), qdd, "qdd");
}

// τ = … + Jᵀ h_e, (7.42); the tip's Jacobian as in (3.35).
TEST_F(PlanarArm, TipForce) {
  const S s_1 = sin(q[0]), c_1 = cos(q[0]), s_12 = sin(S(q[0] + q[1])), c_12 = cos(S(q[0] + q[1]));
  Matrix J = Matrix::Zero(6, 2);
  J.row(0) << -a_1 * s_1 - a_2 * s_12, -a_2 * s_12;
  J.row(1) << a_1 * c_1 + a_2 * c_12, a_2 * c_12;
  J.row(5) << S(1), S(1);
  expect_near(ref::jacobian(robot, q), J, "J");
  ref::Environment<S> environment;
  environment.f_e = {S("3.3"), S("-4.7"), S("2.9")};
  environment.mu_e = {S("0.7"), S("1.1"), S("-1.9")};
  Vector h_e(6);
  h_e << environment.f_e, environment.mu_e;
  expect_near(ref::inverse_dynamics(robot, q, qd, qdd, environment),
              Vector(B() * qdd + C() * qd + gravity() + J.transpose() * h_e), "tau");
}

TEST_F(PlanarArm, FrictionOpposesMotionAndVanishesAtRest) {
  robot.joints[0].viscous = S("0.3");
  robot.joints[0].coulomb = S("1.1");
  robot.joints[1].coulomb = S("0.6");
  expect_near(ref::bias(robot, q, qd), Vector(C() * qd + gravity() + two(S("0.3") * qd[0] + S("1.1"), -S("0.6"))),
              "bias");
  expect_near(ref::gravity(robot, q), gravity(), "g");
}

TEST_F(PlanarArm, ArmatureIsOnTheDiagonalOnly) {
  robot.joints[0].armature = S("0.21");
  robot.joints[1].armature = S("0.34");
  expect_near(ref::inertia_matrix(robot, q), Matrix(B() + square(S("0.21"), S(0), S(0), S("0.34"))), "B");
  expect_near(ref::coriolis_matrix(robot, q, qd), C(), "C");
}

}  // namespace
}  // namespace flatdyn
