// SPDX-License-Identifier: GPL-2.0-or-later
// The reference against first principles: Lagrange's equations (7.3), by differentiating its energies, on random trees
// with rotors on any link. Derivatives are central differences in 60 digits with a step of 1e-18, accurate to 1e-34.
#include <gtest/gtest.h>

#include "flatdyn/reference/derivatives.hpp"
#include "support/reference_robots.hpp"
#include "truth/reference/magnitude.hpp"

namespace flatdyn {
namespace {

namespace ref = reference;
using testing::Draw;
using testing::random_reference_robot;
using testing::ReferenceState;
using S = testing::Digits50;
using Vector = ref::VectorX<S>;
using Matrix = ref::MatrixX<S>;

const S kStep("1e-18");
const S kDifferenced("1e-32");  // tolerance for derivatives
const S kExact("1e-50");        // tolerance for everything else

S largest(const Matrix& m) { return m.size() == 0 ? S(0) : m.cwiseAbs().maxCoeff(); }

#define EXPECT_SMALL(difference, scale, tolerance) \
  EXPECT_LE(largest(difference), S(tolerance) * (S(1) + largest(scale))) << #difference

class RandomRobots : public ::testing::TestWithParam<unsigned> {
 protected:
  ref::Robot<S> robot = random_reference_robot<S>(GetParam());
  int n = robot.size();
  ReferenceState<S> state{GetParam() + 1000, n};

  Vector unit(int i) const { return Vector::Unit(n, i); }

  // d/dq_k of f(q).
  template <class F>
  auto slope(const F& f, int k) const {
    using Result = decltype(f(state.q));
    return Result((f(Vector(state.q + kStep * unit(k))) - f(Vector(state.q - kStep * unit(k)))) / (2 * kStep));
  }
  // B is the Hessian of T, a quadratic form in q̇, by polarisation.
  Matrix inertia_from_energy(const Vector& q) const {
    const auto T = [&](const Vector& qd) { return ref::kinetic_energy(robot, q, qd); };
    Matrix B(n, n);
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) B(i, j) = T(unit(i) + unit(j)) - T(unit(i)) - T(unit(j));
    }
    return B;
  }
  // c_ijk of (7.45) by its definition, in the reference's layout.
  Matrix christoffel_by_definition() const {
    std::vector<Matrix> dB;
    for (int k = 0; k < n; ++k) dB.push_back(slope([&](const Vector& q) { return inertia_from_energy(q); }, k));
    Matrix c(n, n * (n + 1) / 2);
    for (int i = 0; i < n; ++i) {
      for (int k = 0; k < n; ++k) {
        for (int j = 0; j <= k; ++j) {
          c(i, k * (k + 1) / 2 + j) =
              (dB[std::size_t(k)](i, j) + dB[std::size_t(j)](i, k) - dB[std::size_t(i)](j, k)) / 2;
        }
      }
    }
    return c;
  }
  Vector friction() const {
    Vector result(n);
    for (const auto& joint : robot.joints) {
      if (joint.index < 0) continue;
      const S& v = state.qd[joint.index];
      result[joint.index] = joint.viscous * v + joint.coulomb * (v > 0 ? 1 : v < 0 ? -1 : 0);
    }
    return result;
  }
};

TEST_P(RandomRobots, InertiaMatrixIsThatOfTheKineticEnergy) {
  const Matrix B = ref::inertia_matrix(robot, state.q);
  EXPECT_SMALL(B - inertia_from_energy(state.q), B, kExact);
  EXPECT_SMALL(B - B.transpose(), B, kExact);
  EXPECT_EQ(B.llt().info(), Eigen::Success);
}

TEST_P(RandomRobots, GravityIsTheSlopeOfThePotentialEnergy) {
  Vector g(n);
  for (int k = 0; k < n; ++k) g[k] = slope([&](const Vector& q) { return ref::potential_energy(robot, q); }, k);
  EXPECT_SMALL(ref::gravity(robot, state.q) - g, g, kDifferenced);
}

TEST_P(RandomRobots, ChristoffelSymbolsAreThoseOfTheirDefinition) {
  const Matrix c = christoffel_by_definition();
  EXPECT_SMALL(ref::christoffel(robot, state.q) - c, c, kDifferenced);
}

TEST_P(RandomRobots, InverseDynamicsAreLagrangesEquations) {
  const Matrix c = christoffel_by_definition();
  Vector tau = inertia_from_energy(state.q) * state.qdd + ref::gravity(robot, state.q) + friction();
  for (int k = 0; k < n; ++k) {
    for (int j = 0; j <= k; ++j) {
      tau += c.col(k * (k + 1) / 2 + j) * state.qd[j] * state.qd[k] * S(j == k ? 1 : 2);
    }
  }
  EXPECT_SMALL(ref::inverse_dynamics(robot, state.q, state.qd, state.qdd) - tau, tau, kDifferenced);
}

// dT/dt = q̇ᵀ (τ - friction - g), (7.50).
TEST_P(RandomRobots, EnergyIsBalanced) {
  const auto T = [&](const S& t) {
    return ref::kinetic_energy(robot, Vector(state.q + t * state.qd), Vector(state.qd + t * state.qdd));
  };
  const S rate = (T(kStep) - T(-kStep)) / (2 * kStep);
  const Vector tau = ref::inverse_dynamics(robot, state.q, state.qd, state.qdd);
  const S power = state.qd.dot(tau - friction() - ref::gravity(robot, state.q));
  EXPECT_LE(abs(S(rate - power)), kDifferenced * (1 + tau.norm() * state.qd.norm()));
}

// wᵀ (Ḃ - 2C) w = 0 for any w, (7.48).
TEST_P(RandomRobots, CoriolisMatrixIsTheSkewSymmetricOne) {
  const auto B = [&](const S& t) { return ref::inertia_matrix(robot, Vector(state.q + t * state.qd)); };
  const Matrix N = (B(kStep) - B(-kStep)) / (2 * kStep) - 2 * ref::coriolis_matrix(robot, state.q, state.qd);
  EXPECT_SMALL(N + N.transpose(), N, kDifferenced);
  const Vector velocity_torque = ref::bias(robot, state.q, state.qd) - ref::gravity(robot, state.q) - friction();
  EXPECT_SMALL(ref::coriolis_matrix(robot, state.q, state.qd) * state.qd - velocity_torque, velocity_torque, kExact);
}

TEST_P(RandomRobots, ForwardDynamicsUndoInverseDynamics) {
  const Vector tau = ref::inverse_dynamics(robot, state.q, state.qd, state.qdd);
  EXPECT_SMALL(ref::forward_dynamics(robot, state.q, state.qd, tau) - state.qdd, state.qdd, S("1e-42"));
}

TEST_P(RandomRobots, DerivativesOfInverseDynamicsAreItsSlopes) {
  const auto d = ref::inverse_dynamics_derivatives(robot, state.q, state.qd, state.qdd);
  for (int k = 0; k < n; ++k) {
    const auto by_q = slope([&](const Vector& q) { return ref::inverse_dynamics(robot, q, state.qd, state.qdd); }, k);
    const Vector step = kStep * unit(k);
    const Vector by_qd = (ref::inverse_dynamics(robot, state.q, Vector(state.qd + step), state.qdd) -
                          ref::inverse_dynamics(robot, state.q, Vector(state.qd - step), state.qdd)) /
                         (2 * kStep);
    EXPECT_SMALL(d.dq.col(k) - by_q, by_q, kDifferenced);
    EXPECT_SMALL(d.dqd.col(k) - by_qd, by_qd, kDifferenced);
  }
}

TEST_P(RandomRobots, DerivativesOfForwardDynamicsAreItsSlopes) {
  const Vector tau = ref::inverse_dynamics(robot, state.q, state.qd, state.qdd);
  const auto d = ref::forward_dynamics_derivatives(robot, state.q, state.qd, tau);
  for (int k = 0; k < n; ++k) {
    const auto by_q = slope([&](const Vector& q) { return ref::forward_dynamics(robot, q, state.qd, tau); }, k);
    const Vector step = kStep * unit(k);
    const Vector by_qd = (ref::forward_dynamics(robot, state.q, Vector(state.qd + step), tau) -
                          ref::forward_dynamics(robot, state.q, Vector(state.qd - step), tau)) /
                         (2 * kStep);
    const Vector by_tau = ref::forward_dynamics(robot, state.q, state.qd, Vector(tau + unit(k))) - state.qdd;
    EXPECT_SMALL(d.dq.col(k) - by_q, by_q, kDifferenced);
    EXPECT_SMALL(d.dqd.col(k) - by_qd, by_qd, kDifferenced);
    EXPECT_SMALL(d.dtau.col(k) - by_tau, by_tau, kDifferenced);
  }
}

TEST_P(RandomRobots, JacobianIsTheSlopeOfTheTipsPose) {
  const Matrix J = ref::jacobian(robot, state.q);
  const ref::Matrix3<S> R = ref::tip_pose(robot, state.q).R;
  for (int k = 0; k < n; ++k) {
    const Vector dp = slope([&](const Vector& q) { return ref::tip_pose(robot, q).p; }, k);
    // Ṙ Rᵀ = S(ω)
    const ref::Matrix3<S> W = slope([&](const Vector& q) { return ref::tip_pose(robot, q).R; }, k) * R.transpose();
    const ref::Vector3<S> omega(W(2, 1), W(0, 2), W(1, 0));
    EXPECT_SMALL(J.col(k).head(3) - dp, dp, kDifferenced);
    EXPECT_SMALL(J.col(k).tail(3) - omega, omega, kDifferenced);
  }
}

TEST_P(RandomRobots, JacobianDotTimesSpeedIsTheJacobiansRate) {
  const auto J = [&](const S& t) { return ref::jacobian(robot, Vector(state.q + t * state.qd)); };
  const Vector rate = (J(kStep) - J(-kStep)) / (2 * kStep) * state.qd;
  EXPECT_SMALL(ref::jacobian_dot_qd(robot, state.q, state.qd) - rate, rate, kDifferenced);
}

TEST_P(RandomRobots, TipForceActsThroughTheJacobian) {
  Vector h_e(6);
  h_e << state.h_e.f_e, state.h_e.mu_e;
  const Vector torque = ref::inverse_dynamics(robot, state.q, state.qd, state.qdd, state.h_e) -
                        ref::inverse_dynamics(robot, state.q, state.qd, state.qdd);
  const Vector expected = ref::jacobian(robot, state.q).transpose() * h_e;
  EXPECT_SMALL(torque - expected, expected, kExact);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomRobots, ::testing::Range(1u, 13u));

// The same robot and state in another scalar type, against 50 digits on the scale of the torque's own terms.
template <class T>
class Scalars : public ::testing::Test {};
using ScalarTypes = ::testing::Types<float, double, long double>;
TYPED_TEST_SUITE(Scalars, ScalarTypes);

template <class T>
Matrix widened(const ref::MatrixX<T>& m) {
  return m.unaryExpr([](const T& x) { return S(x); });
}

template <class T>
ref::Robot<S> widened(const ref::Robot<T>& robot) {
  const auto vector = [](const ref::Vector3<T>& v) { return ref::Vector3<S>(widened<T>(v)); };
  const auto matrix = [](const ref::Matrix3<T>& m) { return ref::Matrix3<S>(widened<T>(m)); };
  ref::Robot<S> result;
  result.gravity = vector(robot.gravity);
  result.tip = robot.tip;
  result.R_tip = matrix(robot.R_tip);
  result.p_tip = vector(robot.p_tip);
  for (const auto& link : robot.links) {
    result.links.emplace_back();
    for (const auto& body : link.inertials) {
      result.links.back().inertials.push_back({S(body.mass), vector(body.r_C), matrix(body.inertia)});
    }
  }
  for (const auto& joint : robot.joints) {
    ref::Joint<S> wide{
        joint.type,
        joint.parent,
        joint.child,
        joint.index,
        matrix(joint.R_0),
        matrix(joint.R_1),
        vector(joint.p_0),
        vector(joint.p_1),
        vector(joint.axis),
        S(joint.viscous),
        S(joint.coulomb),
        S(joint.armature),
        {joint.rotor.carrier, S(joint.rotor.gear_ratio), S(joint.rotor.inertia), vector(joint.rotor.axis)}};
    result.joints.push_back(wide);
  }
  return result;
}

TYPED_TEST(Scalars, AgreeWithFiftyDigitsWithinTheirOwnRounding) {
  using T = TypeParam;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const ref::Robot<T> robot = random_reference_robot<T>(seed, {.joints = 7});
    const ref::Robot<S> exact = widened(robot);
    const ref::Robot<double> scale_robot = random_reference_robot<double>(seed, {.joints = 7});
    const ReferenceState<T> state(seed, robot.size());
    const Vector q = widened<T>(state.q), qd = widened<T>(state.qd), qdd = widened<T>(state.qdd);
    const Matrix tau = widened<T>(ref::inverse_dynamics(robot, state.q, state.qd, state.qdd));
    const ref::VectorX<double> scale =
        ref::torque_magnitude(scale_robot, state.q.template cast<double>(), state.qd.template cast<double>(),
                              state.qdd.template cast<double>());
    const Vector error = tau - Matrix(ref::inverse_dynamics(exact, q, qd, qdd));
    for (Eigen::Index i = 0; i < error.size(); ++i) {
      EXPECT_LE(abs(error[i]), S(16) * S(std::numeric_limits<T>::epsilon()) * S(scale[i])) << "seed " << seed;
    }
  }
}

}  // namespace
}  // namespace flatdyn
