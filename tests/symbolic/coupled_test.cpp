// SPDX-License-Identifier: GPL-2.0-or-later
// Coupled joints of the textbook: the parallelogram arm of 7.3.3, found from its loop, and absolute angles
// (Problem 7.6).
#include <gtest/gtest.h>

#include "derivation/closed_form/closed_form.hpp"
#include "derivation/parameters/base_parameters.hpp"
#include "support/robot_models.hpp"
#include "support/written_model.hpp"
#include "symbolic/textbook_robots.hpp"
#include "truth/definition/sampled_base.hpp"

namespace flatdyn {
namespace {

// The closed form of a robot file, with its symbols by name.
struct Derived {
  explicit Derived(const std::string& file) : model(testing::model_of(file)), form(closed_form(model.mechanism)) {}

  Number operator()(const char* name) const { return testing::symbol(model.mechanism, name); }
  bool equal(const Number& a, const Number& b) const { return reduced(a - b, form).is_zero(); }
  // cos(q_2 - q_1) and sin(q_2 - q_1).
  Number cosine() const { return form.c[0] * form.c[1] + form.s[0] * form.s[1]; }
  Number sine() const { return form.s[1] * form.c[0] - form.c[1] * form.s[0]; }

  LoadedRobot model;
  ClosedForm form;
};

Number square(const Number& x) { return x * x; }

// B_a and g_a as in the chapter, except for I and m of link 1'' in b_a22, where the book has those of 1'.
TEST(Parallelogram, IsTheBooks) {
  const Derived arm("parallelogram.toml");
  const Number m1 = arm("m_l1"), m2 = arm("m_l2"), m3 = arm("m_l3"), m1b = arm("m_l1b"), g = arm("g");
  const Number l1 = arm("l_1"), l2 = arm("l_2"), l3 = arm("l_3"), l1b = arm("l_1b"), a1 = arm("a_1"), a1b = arm("a_1b");
  const auto& B = arm.form.B;
  EXPECT_TRUE(arm.equal(B[0][0], arm("I_l1") + m1 * square(l1) + m2 * square(a1) + arm("I_l3") + m3 * square(l3) +
                                     m3 * square(a1) - 2 * a1 * m3 * l3));
  EXPECT_TRUE(arm.equal(B[0][1], (a1 * m2 * l2 + a1b * m3 * (a1 - l3)) * arm.cosine()));
  EXPECT_TRUE(arm.equal(B[1][1], arm("I_l1b") + m1b * square(l1b) + arm("I_l2") + m2 * square(l2) + m3 * square(a1b)));
  EXPECT_TRUE(arm.equal(arm.form.g[0], (m1 * l1 + m2 * a1 - m3 * (l3 - a1)) * g * arm.form.c[0]));
  EXPECT_TRUE(arm.equal(arm.form.g[1], (m1b * l1b + m2 * l2 + m3 * a1b) * g * arm.form.c[1]));
}

// "q = A q_a + b found from the loop": theta_2' = theta_1'' - theta_1', theta_3' = pi - theta_2'.
TEST(Parallelogram, IsFoundFromItsLoop) {
  const Mechanism mechanism = testing::model_of("parallelogram.toml").mechanism;
  const Rows A = {{1, 0}, {-1, 1}, {1, -1}, {0, 1}};
  const std::vector<Number> b = {0, 0, GiNaC::Pi, 0};
  ASSERT_EQ(mechanism.coupling.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(mechanism.offsets[i], b[i]);
    for (std::size_t k = 0; k < 2; ++k) EXPECT_EQ(mechanism.coupling[i][k], A[i][k]);
  }
}

// A rhombus can fold with opposite links on each other; it is not recognised as folded, in any order of joint names.
TEST(Rhombus, IsNotTakenForFolded) {
  for (const char* dependent : {"\"b\", \"c\"", "\"c\", \"b\""}) {
    const std::string text = std::string(R"(name = "rhombus"
[[link]]
joint = "a"
mass = 1
[[link]]
joint = "b"
xyz = [0.5, 0, 0]
rpy = [0, 0, "pi/2"]
mass = 1
[[link]]
joint = "c"
xyz = [0.5, 0, 0]
mass = 1
[[link]]
joint = "d"
parent = "base"
mass = 1
[[loop]]
links = ["link3", "link4"]
from = [0.5, 0, 0]
to = [0.5, 0, 0]
dependent = [)") + dependent +
                             "]\n";
    const Mechanism mechanism = testing::model_of_toml(text).mechanism;
    ASSERT_EQ(mechanism.size(), 2);
    EXPECT_EQ(mechanism.coupling[1], (std::vector<Number>{-1, 1}));
    EXPECT_EQ(mechanism.coupling[2], (std::vector<Number>{1, -1}));
    EXPECT_EQ(mechanism.offsets[1], -GiNaC::Pi / 2);
  }
}

// With m_3' (l_3' - a_1') / (m_2' l_2') = a_1' / a_1'', B_a is diagonal and constant.
TEST(Parallelogram, IsDecoupledByDesign) {
  const Derived arm("parallelogram.toml");
  const Number a1 = arm("a_1");
  const Number l_3 = a1 + a1 / arm("a_1b") * arm("m_l2") * arm("l_2") / arm("m_l3");
  const auto designed = [&](const Number& x) { return x.subs(arm("l_3") == l_3).normal().expand(); };
  EXPECT_FALSE(arm.form.B[0][1].is_zero());
  EXPECT_TRUE(designed(arm.form.B[0][1]).is_zero());
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      for (int k = j; k < 2; ++k) EXPECT_TRUE(designed(arm.form.christoffel(i, j, k)).is_zero());
      for (const auto* trigonometric : {&arm.form.c, &arm.form.s}) {
        for (const GiNaC::symbol& x : *trigonometric) EXPECT_FALSE(designed(arm.form.B[at(i)][at(j)]).has(x));
      }
    }
  }
}

// Without motors there is no Coriolis torque (c_112 = 0), each centrifugal torque comes from the other link's absolute
// velocity, and g_1 does not depend on theta_2.
TEST(AbsoluteAngles, AreProblem7_6) {
  const Derived arm("planar_2r_absolute.toml");
  const Number m2 = arm("m_l2"), a1 = arm("a_1"), l2 = arm("l_2"), k2 = arm("k_r2"), I2 = arm("I_m2");
  const Number h = a1 * m2 * l2 * arm.sine();
  EXPECT_TRUE(arm.equal(arm.form.B[0][1], m2 * a1 * l2 * arm.cosine() + k2 * I2 - k2 * k2 * I2));
  EXPECT_TRUE(arm.equal(arm.form.B[1][1], arm("I_l2") + m2 * square(l2) + k2 * k2 * I2));
  EXPECT_TRUE(arm.form.christoffel(0, 0, 1).is_zero());
  EXPECT_TRUE(arm.form.christoffel(1, 0, 1).is_zero());
  EXPECT_TRUE(arm.equal(arm.form.christoffel(0, 1, 1), -h));
  EXPECT_TRUE(arm.equal(arm.form.christoffel(1, 0, 0), h));
  EXPECT_FALSE(arm.form.g[0].has(arm.form.c[1]));
  EXPECT_TRUE(arm.equal(arm.form.g[1], m2 * l2 * arm("g") * arm.form.c[1]));
}

// B = Tᵀ B' T with q' = T q, for the same arm.
TEST(AbsoluteAngles, AreALinearChangeOfCoordinates) {
  const Derived absolute("planar_2r_absolute.toml"), relative("planar_2r.toml");
  GiNaC::exmap same;  // maps symbols of one file to those of the other, and theta_2 to theta_2' - theta_1'
  for (const FreeSymbol& symbol : relative.model.mechanism.symbols) same[symbol.symbol] = absolute(symbol.name.c_str());
  same[relative.form.c[0]] = absolute.form.c[0];
  same[relative.form.s[0]] = absolute.form.s[0];
  same[relative.form.c[1]] = absolute.cosine();
  same[relative.form.s[1]] = absolute.sine();
  const auto b = [&](std::size_t i, std::size_t j) { return relative.form.B[i][j].subs(same); };
  const auto& B = absolute.form.B;
  EXPECT_TRUE(absolute.equal(B[0][0], b(0, 0) - 2 * b(0, 1) + b(1, 1)));
  EXPECT_TRUE(absolute.equal(B[0][1], b(0, 1) - b(1, 1)));
  EXPECT_TRUE(absolute.equal(B[1][1], b(1, 1)));
}

TEST(Parallelogram, BaseParametersAreThoseOfTheSamples) {
  const Mechanism mechanism = testing::model_of("parallelogram.toml").mechanism;
  const BaseParameters base = base_parameters(mechanism);
  EXPECT_TRUE(compare_with_samples(mechanism, base, ParameterSet::given).equal);
  EXPECT_EQ(base.size(), 8);  // two inertias, and three first moments, each with its x and y
}

}  // namespace
}  // namespace flatdyn
