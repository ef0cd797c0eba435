// SPDX-License-Identifier: GPL-2.0-or-later
// The closed form against Lagrange's equations in GF(p): composite links in link frames against the plain sum (7.32) in
// the base frame, derivatives by GiNaC against dual numbers.
#include <gtest/gtest.h>

#include "derivation/closed_form/closed_form.hpp"
#include "graph/mod_p.hpp"
#include "symbolic/textbook_robots.hpp"
#include "truth/definition/lagrangian.hpp"

namespace flatdyn {
namespace {

using F = ModP<kMersenne61>;

// Arithmetic with a table for the inputs of kind parameter: the robot's symbols, then c, s and d of each joint.
struct TableArithmetic {
  using Scalar = F;
  F constant(const Rational& value) const { return F::from(value); }
  F input(const Input& input) const { return values[static_cast<std::size_t>(input.index)]; }
  F divide(const F& a, const F& b) const { return a / b; }
  F sin(const Graph&, NodeId, const F&) const { throw std::logic_error("no symbolic angle here"); }
  F cos(const Graph&, NodeId, const F&) const { throw std::logic_error("no symbolic angle here"); }
  F tanh(const F&) const { throw std::logic_error("no friction here"); }

  std::vector<F> values;
};

struct Point {
  std::vector<JointPoint<F>> q;
  TableArithmetic arithmetic;
  std::vector<FreeSymbol> symbols;  // the symbols of arithmetic.values
};

Point random_point(const Mechanism& mechanism, const ClosedForm& form, std::uint64_t seed) {
  const ModPArithmetic<> draw(seed);
  Point point;
  point.symbols = mechanism.symbols;
  for (int k = 0; k < static_cast<int>(mechanism.symbols.size()); ++k) {
    point.arithmetic.values.push_back(draw.input({InputKind::parameter, k}));
  }
  for (int i = 0; i < mechanism.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const auto circle = draw.point(draw.input({InputKind::q, i}));
    const F d = draw.input({InputKind::qd, i});
    point.q.push_back({circle.c, circle.s, d});
    for (const GiNaC::symbol& symbol : {form.c[k], form.s[k], form.d[k]}) {
      point.symbols.push_back({symbol, symbol.get_name(), {}});
    }
    for (const F& value : {circle.c, circle.s, d}) point.arithmetic.values.push_back(value);
  }
  return point;
}

void expect_same_as_lagrangian(const Mechanism& mechanism, std::uint64_t seed) {
  const ClosedForm form = closed_form(mechanism);
  Point point = random_point(mechanism, form, seed);
  const NumberMap<TableArithmetic> value(point.symbols, point.arithmetic);
  Lagrangian<F> lagrangian(mechanism_over(mechanism, point.arithmetic), point.q);
  const std::vector<F> g = lagrangian.gravity();
  for (int i = 0; i < form.size(); ++i) {
    const auto row = static_cast<std::size_t>(i);
    EXPECT_EQ(value(form.g[row]), g[row]) << mechanism.name << " g " << i;
    for (int j = 0; j < form.size(); ++j) {
      EXPECT_EQ(value(form.B[row][static_cast<std::size_t>(j)]), lagrangian.inertia()(i, j))
          << mechanism.name << " b " << i << ' ' << j;
      for (int k = 0; k < form.size(); ++k) {
        EXPECT_EQ(value(form.christoffel(i, j, k)), lagrangian.christoffel(i, j, k))
            << mechanism.name << " c " << i << ' ' << j << ' ' << k;
      }
    }
  }
}

TEST(ClosedFormAndLagrangian, AgreeOnRandomTrees) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    const Mechanism mechanism = make_mechanism(testing::random_tree(seed, 4));
    expect_same_as_lagrangian(mechanism, seed);
  }
}

TEST(ClosedFormAndLagrangian, AgreeOnTextbookRobotsWithSymbols) {
  for (const Robot& robot : {testing::two_link_planar(), testing::two_link_cartesian(), testing::pendulum()}) {
    expect_same_as_lagrangian(make_mechanism(robot), 7);
  }
}

// An arm like real ones, with quarter turns between the axes: revolute except for one joint, with all inertial
// parameters and motors.
Robot seven_axis_arm(unsigned seed) {
  testing::Numbers numbers(seed);
  Robot robot;
  robot.name = "arm_" + std::to_string(seed);
  robot.links.push_back({"base", {}, {}});
  robot.root = 0;
  for (int i = 0; i < 7; ++i) {
    const std::string n = std::to_string(i + 1);
    robot.links.push_back(
        testing::link("link" + n, numbers.positive(), numbers.vector(), testing::real_tensor(numbers)));
    const Pose origin{{testing::translation({numbers.fraction(), 0, numbers.fraction()}),
                       testing::rotation(Displacement::Kind::rotation_x, GiNaC::Pi * numbers.integer(-1, 1) / 2)},
                      {}};
    const JointType type = i == 2 ? JointType::prismatic : JointType::revolute;
    Joint joint = testing::joint("joint" + n, type, i, i + 1, origin, {0, 0, 1});
    joint.motor = testing::motor(numbers);
    robot.joints.push_back(joint);
  }
  robot.tip = 7;
  return robot;
}

TEST(ClosedFormAndLagrangian, AgreeOnSevenAxisArms) {
  for (const unsigned seed : {1U, 2U}) expect_same_as_lagrangian(make_mechanism(seven_axis_arm(seed)), seed);
}

}  // namespace
}  // namespace flatdyn
