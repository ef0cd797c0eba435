// SPDX-License-Identifier: GPL-2.0-or-later
// The closed form of the textbook's robots, expression against expression.
#include "derivation/closed_form/closed_form.hpp"

#include <gtest/gtest.h>

#include "symbolic/textbook_robots.hpp"

namespace flatdyn {
namespace {

using testing::symbol;

// Two polynomials are the same if their difference vanishes once sin² is replaced.
::testing::AssertionResult same(const Number& a, const Number& b, const ClosedForm& form) {
  const Number difference = reduced(a - b, form);
  if (difference.is_zero()) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << a << " differs from " << b << " by " << difference;
}

struct Planar {
  Mechanism mechanism = make_mechanism(testing::two_link_planar());
  ClosedForm form = closed_form(mechanism);
  Number operator()(const std::string& name) const { return symbol(mechanism, name); }
};

TEST(ClosedForm, InertiaMatrixOfThePlanarArmIsThatOf732) {
  const Planar p;
  const Number c_2 = p.form.c[1], a_1 = p("a_1"), l_1 = p("l_1"), l_2 = p("l_2");
  const Number b_11 = p("I_l1") + p("m_l1") * l_1 * l_1 + p("k_r1") * p("k_r1") * p("I_m1") + p("I_l2") +
                      p("m_l2") * (a_1 * a_1 + l_2 * l_2 + 2 * a_1 * l_2 * c_2) + p("I_m2") + p("m_m2") * a_1 * a_1;
  const Number b_12 = p("I_l2") + p("m_l2") * (l_2 * l_2 + a_1 * l_2 * c_2) + p("k_r2") * p("I_m2");
  const Number b_22 = p("I_l2") + p("m_l2") * l_2 * l_2 + p("k_r2") * p("k_r2") * p("I_m2");
  EXPECT_TRUE(same(p.form.B[0][0], b_11, p.form));
  EXPECT_TRUE(same(p.form.B[0][1], b_12, p.form));
  EXPECT_TRUE(same(p.form.B[1][0], b_12, p.form));
  EXPECT_TRUE(same(p.form.B[1][1], b_22, p.form));
}

TEST(ClosedForm, ChristoffelSymbolsOfThePlanarArmAreThoseOf732) {
  const Planar p;
  const Number h = -p("m_l2") * p("a_1") * p("l_2") * p.form.s[1];
  EXPECT_TRUE(same(p.form.christoffel(0, 0, 0), 0, p.form));
  EXPECT_TRUE(same(p.form.christoffel(0, 0, 1), h, p.form));
  EXPECT_TRUE(same(p.form.christoffel(0, 1, 0), h, p.form));
  EXPECT_TRUE(same(p.form.christoffel(0, 1, 1), h, p.form));
  EXPECT_TRUE(same(p.form.christoffel(1, 0, 0), -h, p.form));
  EXPECT_TRUE(same(p.form.christoffel(1, 0, 1), 0, p.form));
  EXPECT_TRUE(same(p.form.christoffel(1, 1, 1), 0, p.form));
}

TEST(ClosedForm, GravityOfThePlanarArmIsThatOf732) {
  const Planar p;
  const Number c_1 = p.form.c[0], c_12 = c_1 * p.form.c[1] - p.form.s[0] * p.form.s[1];
  const Number g_2 = p("m_l2") * p("l_2") * p("g") * c_12;
  const Number g_1 = (p("m_l1") * p("l_1") + p("m_m2") * p("a_1") + p("m_l2") * p("a_1")) * p("g") * c_1 + g_2;
  EXPECT_TRUE(same(p.form.g[0], g_1, p.form));
  EXPECT_TRUE(same(p.form.g[1], g_2, p.form));
}

TEST(ClosedForm, CartesianArmIsThatOf731) {
  const Mechanism mechanism = make_mechanism(testing::two_link_cartesian());
  const ClosedForm form = closed_form(mechanism);
  const auto p = [&](const std::string& name) { return symbol(mechanism, name); };
  const Number mass = p("m_l1") + p("m_m2") + p("m_l2");
  EXPECT_TRUE(same(form.B[0][0], mass + p("k_r1") * p("k_r1") * p("I_m1"), form));
  EXPECT_TRUE(same(form.B[0][1], 0, form));
  EXPECT_TRUE(same(form.B[1][1], p("m_l2") + p("k_r2") * p("k_r2") * p("I_m2"), form));
  EXPECT_TRUE(same(form.g[0], mass * p("g"), form));
  EXPECT_TRUE(same(form.g[1], 0, form));
  for (const std::vector<Number>& row : form.c_ijk) {
    for (const Number& c : row) EXPECT_TRUE(same(c, 0, form));
  }
}

TEST(ClosedForm, PendulumIsThatOfExample71) {
  const Mechanism mechanism = make_mechanism(testing::pendulum());
  const ClosedForm form = closed_form(mechanism);
  const auto p = [&](const std::string& name) { return symbol(mechanism, name); };
  EXPECT_TRUE(same(form.B[0][0], p("I") + p("I_m") * p("k_r") * p("k_r"), form));
  EXPECT_TRUE(same(form.g[0], p("m") * p("g") * p("l") * form.s[0], form));
}

TEST(ClosedForm, ReplacesSquaresOfSines) {
  const Planar p;
  const Number s = p.form.s[0], c = p.form.c[0], alpha = p("a_1");
  EXPECT_TRUE(reduced(s * s * s * s + 2 * c * c - c * c * c * c, p.form).is_equal(1));
  EXPECT_TRUE(reduced(pow(GiNaC::sin(alpha), 2) + pow(GiNaC::cos(alpha), 2), p.form).is_equal(1));
  EXPECT_TRUE(reduced(s * s * s, p.form).is_equal((s - s * c * c).expand()));
}

}  // namespace
}  // namespace flatdyn
