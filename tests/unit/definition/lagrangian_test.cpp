// SPDX-License-Identifier: GPL-2.0-or-later
// Lagrange's equations over a field: against (7.82) with numbers, and the properties of 7.2 in GF(p).
#include <gtest/gtest.h>

#include <cmath>

#include "graph/arithmetic.hpp"
#include "graph/mod_p.hpp"
#include "support/robots.hpp"
#include "truth/definition/lagrangian.hpp"

namespace flatdyn {
namespace {

using F = ModP<kMersenne61>;

struct InField {
  std::vector<JointPoint<F>> q;
  std::vector<F> qd, qdd, sign_qd;
  Lagrangian<F> lagrangian;
};

std::vector<F> drawn(const ModPArithmetic<>& draw, InputKind kind, int count) {
  std::vector<F> result;
  for (int i = 0; i < count; ++i) result.push_back(draw.input({kind, i}));
  return result;
}

std::vector<JointPoint<F>> random_points(const ModPArithmetic<>& draw, int count) {
  std::vector<JointPoint<F>> result;
  for (const F& q : drawn(draw, InputKind::q, count)) {
    const auto point = draw.point(q);
    result.push_back({point.c, point.s, q});
  }
  return result;
}

InField in_field(const Mechanism& mechanism, std::uint64_t seed) {
  ModPArithmetic<> draw(seed);
  const int n = mechanism.size();
  const std::vector<JointPoint<F>> q = random_points(draw, n);
  return {q, drawn(draw, InputKind::qd, n), drawn(draw, InputKind::qdd, n), drawn(draw, InputKind::tau, n),
          Lagrangian<F>(mechanism_over(mechanism, draw), q)};
}

F inner_product(const std::vector<F>& a, const std::vector<F>& b) {
  F sum(0);
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

// Two point masses of 3 and 2 kg at the ends of rods of 1 and 0.5 m, and a rotor: (7.82) by hand.
TEST(Lagrangian, GivesTheEquationsOfThePlanarArmInDoubles) {
  Robot robot;
  robot.links = {{"base", {}, {}},
                 testing::link("one", 3, {1, 0, 0}, zero_matrix()),
                 testing::link("two", 2, {GiNaC::numeric(1, 2), 0, 0}, zero_matrix())};
  robot.joints = {testing::joint("one", JointType::revolute, 0, 1, {}, {0, 0, 1}),
                  testing::joint("two", JointType::revolute, 1, 2, {{testing::translation({1, 0, 0})}, {}}, {0, 0, 1})};
  robot.joints[1].motor = Motor{};
  robot.joints[1].motor->gear_ratio.number = 100;
  robot.joints[1].motor->inertia_axial.number = GiNaC::numeric(1, 100);
  robot.root = 0;
  robot.tip = 2;
  robot.gravity = {0, -10, 0};
  const Mechanism mechanism = make_mechanism(robot);
  RealArithmetic<double> arithmetic([](const Input&) { return 0.0; });
  const double q1 = 0.3, q2 = -1.1, v1 = 0.7, v2 = 2.5, a1 = -1.5, a2 = 0.4;
  Lagrangian<double> lagrangian(mechanism_over(mechanism, arithmetic),
                                {{std::cos(q1), std::sin(q1), 0}, {std::cos(q2), std::sin(q2), 0}});
  const double b_11 = 3 + 2 * (1.25 + std::cos(q2)) + 0.01, b_12 = 2 * (0.25 + 0.5 * std::cos(q2)) + 1, b_22 = 100.5;
  const double h = -std::sin(q2), g_2 = 10 * std::cos(q1 + q2), g_1 = 50 * std::cos(q1) + g_2;
  const std::vector<double> tau = lagrangian.inverse_dynamics({v1, v2}, {a1, a2}, {0, 0});
  EXPECT_NEAR(tau[0], b_11 * a1 + b_12 * a2 + 2 * h * v1 * v2 + h * v2 * v2 + g_1, 1e-12);
  EXPECT_NEAR(tau[1], b_12 * a1 + b_22 * a2 - h * v1 * v1 + g_2, 1e-12);
  EXPECT_NEAR(lagrangian.kinetic_energy({v1, v2}), (b_11 * v1 * v1 + 2 * b_12 * v1 * v2 + b_22 * v2 * v2) / 2, 1e-12);
  EXPECT_NEAR(lagrangian.potential_energy(), 50 * std::sin(q1) + 10 * std::sin(q1 + q2), 1e-12);
}

// B symmetric, c_ijk = c_ikj (7.46), and dB/dt - 2 C skew-symmetric (7.48), in GF(p).
TEST(Lagrangian, HasThePropertiesOf72) {
  for (const unsigned seed : {2U, 5U, 8U}) {
    const Mechanism mechanism = make_mechanism(testing::random_tree(seed, 7));
    InField at = in_field(mechanism, seed);
    const int n = mechanism.size();
    const Matrix<F> C = at.lagrangian.coriolis_matrix(at.qd);
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        EXPECT_EQ(at.lagrangian.inertia()(i, j), at.lagrangian.inertia()(j, i));
        F rate_ij(0);
        for (int k = 0; k < n; ++k) {
          EXPECT_EQ(at.lagrangian.christoffel(i, j, k), at.lagrangian.christoffel(i, k, j));
          rate_ij += at.lagrangian.inertia_derivative(i, j, k) * at.qd[static_cast<std::size_t>(k)];
        }
        EXPECT_EQ(rate_ij - C(i, j) - C(j, i), F(0));
      }
    }
  }
}

// The derivative of the potential energy along a joint, by duals through the poses, is g (7.39).
TEST(Lagrangian, GravityIsTheDerivativeOfPotentialEnergy) {
  const Mechanism mechanism = make_mechanism(testing::random_tree(6, 7));
  const InField at = in_field(mechanism, 6);
  const MechanismOver<F>& m = at.lagrangian.mechanism();
  const std::vector<F> g = at.lagrangian.gravity();
  for (std::size_t k = 0; k < g.size(); ++k) {
    std::vector<JointPoint<Dual<F>>> q;
    for (std::size_t i = 0; i < g.size(); ++i) {
      const F rate(i == k ? 1 : 0);
      q.push_back({{at.q[i].c, -at.q[i].s * rate}, {at.q[i].s, at.q[i].c * rate}, {at.q[i].d, rate}});
    }
    const auto poses = body_poses(m, q);
    Dual<F> energy;
    for (std::size_t i = 0; i < g.size(); ++i) {
      const auto& body = m.bodies[i].inertia;
      const auto moment = plus(scaled(body.mass, poses[i].p), times(poses[i].R, body.first_moment));
      energy += -dot(m.gravity, moment);
    }
    EXPECT_EQ(energy.derivative, g[k]);
    EXPECT_EQ(energy.value - dot(m.gravity, m.base.first_moment), at.lagrangian.potential_energy());
  }
}

// The power of the tip force is that of its joint torques; kinetic energy changes by the work of inertial torques.
TEST(Lagrangian, BalancesPower) {
  const Mechanism mechanism = make_mechanism(testing::random_tree(7, 6, true));
  InField at = in_field(mechanism, 7);
  const ModPArithmetic<> draw(70);
  const std::vector<F> h_e = drawn(draw, InputKind::h_e, 6);
  const std::vector<F> twist = times(at.lagrangian.jacobian(at.lagrangian.mechanism().tip), at.qd);
  EXPECT_EQ(inner_product(h_e, twist), inner_product(at.lagrangian.tip_torques(h_e), at.qd));

  std::vector<F> inertial = at.lagrangian.inverse_dynamics(at.qd, at.qdd, at.sign_qd);
  const std::vector<F> g = at.lagrangian.gravity(), friction = at.lagrangian.friction(at.qd, at.sign_qd);
  for (std::size_t i = 0; i < inertial.size(); ++i) inertial[i] -= g[i] + friction[i];
  F change = inner_product(at.qd, times(at.lagrangian.inertia(), at.qdd));
  for (int i = 0; i < mechanism.size(); ++i) {
    for (int j = 0; j < mechanism.size(); ++j) {
      for (int k = 0; k < mechanism.size(); ++k) {
        const auto u = [&](int index) { return at.qd[static_cast<std::size_t>(index)]; };
        change += at.lagrangian.inertia_derivative(i, j, k) * u(i) * u(j) * u(k) / F(2);
      }
    }
  }
  EXPECT_EQ(inner_product(inertial, at.qd), change);
}

TEST(Lagrangian, MapsSymbolsTheirSinesAndReciprocals) {
  const GiNaC::symbol a("a"), alpha("alpha"), stranger("stranger");
  const std::vector<FreeSymbol> symbols = {{a, "a", {}}, {alpha, "alpha", {}}};
  ModPArithmetic<> draw(5);
  const NumberMap<ModPArithmetic<>> value(symbols, draw);
  const F A = draw.input({InputKind::parameter, 0});
  const auto turn = draw.point(draw.input({InputKind::parameter, 1}));
  EXPECT_EQ(value(3 * a * a / 7 - 1), F(3) * A * A / F(7) - F(1));
  EXPECT_EQ(value(GiNaC::pow(a + 2, -2)), F(1) / ((A + F(2)) * (A + F(2))));
  EXPECT_EQ(value(GiNaC::sin(2 * alpha)), F(2) * turn.s * turn.c);
  EXPECT_EQ(value(GiNaC::cos(-alpha)), turn.c);
  EXPECT_THROW(value(stranger), Failure);
  EXPECT_THROW(value(GiNaC::sqrt(Number(a))), Failure);
  EXPECT_THROW(value(GiNaC::exp(Number(a))), Failure);
  EXPECT_THROW(value(GiNaC::sin(a * alpha)), Failure);
}

}  // namespace
}  // namespace flatdyn
