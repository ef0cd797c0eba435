// SPDX-License-Identifier: GPL-2.0-or-later
// The output of `derive`, character by character.
#include "derivation/notation/derive.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/diagnostics/diagnostics.hpp"
#include "symbolic/textbook_robots.hpp"

namespace flatdyn {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(DeriveText, PlanarArmAsIn732) {
  EXPECT_EQ(
      derive_text(make_mechanism(testing::two_link_planar())),
      R"(two_link_planar
q_1: joint1 (revolute)
q_2: joint2 (revolute)

Inertia matrix B(q), (7.32)
b_11 = I_l1 + m_l1 l_1^2 + k_r1^2 I_m1 + I_l2 + m_l2 (a_1^2 + l_2^2 + 2 a_1 l_2 c_2) + I_m2 + m_m2 a_1^2
b_12 = b_21 = I_l2 + m_l2 (l_2^2 + a_1 l_2 c_2) + k_r2 I_m2
b_22 = I_l2 + m_l2 l_2^2 + k_r2^2 I_m2

Christoffel symbols c_ijk(q), (7.45); all others are zero
h = -m_l2 a_1 l_2 s_2
c_112 = c_121 = h
c_122 = h
c_211 = -h

Gravity g(q), (7.39)
g_1 = (m_l1 l_1 + m_l2 a_1 + m_m2 a_1) g c_1 + m_l2 l_2 g c_12
g_2 = m_l2 l_2 g c_12

Equations of motion (7.42)
)"
      "(I_l1 + m_l1 l_1^2 + k_r1^2 I_m1 + I_l2 + m_l2 (a_1^2 + l_2^2 + 2 a_1 l_2 c_2) + I_m2 + m_m2 a_1^2) qdd_1 + "
      "(I_l2 + m_l2 (l_2^2 + a_1 l_2 c_2) + k_r2 I_m2) qdd_2 - 2 m_l2 a_1 l_2 s_2 qd_1 qd_2 - m_l2 a_1 l_2 s_2 qd_2^2 "
      "+ "
      "(m_l1 l_1 + m_l2 a_1 + m_m2 a_1) g c_1 + m_l2 l_2 g c_12 = tau_1\n"
      "(I_l2 + m_l2 (l_2^2 + a_1 l_2 c_2) + k_r2 I_m2) qdd_1 + (I_l2 + m_l2 l_2^2 + k_r2^2 I_m2) qdd_2 + "
      "m_l2 a_1 l_2 s_2 qd_1^2 + m_l2 l_2 g c_12 = tau_2\n"
      R"(
c_1 = cos(q_1), s_1 = sin(q_1), c_12 = cos(q_1 + q_2); c_ijk to the left of = is a Christoffel symbol
)");
}

TEST(DeriveText, CartesianArmAsIn731) {
  EXPECT_EQ(derive_text(make_mechanism(testing::two_link_cartesian())), R"(two_link_cartesian
q_1 = d_1: joint1 (prismatic)
q_2 = d_2: joint2 (prismatic)

Inertia matrix B(q), (7.32)
b_11 = m_l1 + k_r1^2 I_m1 + m_l2 + m_m2
b_12 = b_21 = 0
b_22 = m_l2 + k_r2^2 I_m2

Christoffel symbols c_ijk(q), (7.45): all are zero

Gravity g(q), (7.39)
g_1 = (m_l1 + m_l2 + m_m2) g
g_2 = 0

Equations of motion (7.42)
(m_l1 + k_r1^2 I_m1 + m_l2 + m_m2) qdd_1 + (m_l1 + m_l2 + m_m2) g = tau_1
(m_l2 + k_r2^2 I_m2) qdd_2 = tau_2
)");
}

TEST(DeriveText, PendulumAsInExample71) {
  EXPECT_THAT(derive_text(make_mechanism(testing::pendulum())),
              HasSubstr("\n(I + k_r^2 I_m) qdd_1 + (F + k_r^2 F_m) qd_1 + m l g s_1 = tau_1\n"));
}

TEST(DeriveText, IsTheSameInWhateverOrderGiNaCHasTheSymbols) {
  const std::string first = derive_text(make_mechanism(testing::two_link_planar()));
  for (int round = 0; round < 5; ++round) {
    const std::vector<GiNaC::symbol> padding(static_cast<std::size_t>(7 * round));  // moves addresses and hashes
    EXPECT_EQ(derive_text(make_mechanism(testing::two_link_planar(round % 2 == 0))), first);
  }
}

TEST(DeriveLatex, PlanarArm) {
  const std::string text = derive_latex(make_mechanism(testing::two_link_planar()));
  EXPECT_THAT(text, HasSubstr("  b_{22} &= I_{l_{2}} + m_{l_{2}} l_{2}^2 + k_{r_{2}}^2 I_{m_{2}}\n"));
  EXPECT_THAT(text, HasSubstr("  h &= -m_{l_{2}} a_{1} l_{2} s_{2}\n"));
  EXPECT_THAT(text, HasSubstr("  c_{112} = c_{121} &= h \\\\\n"));
  EXPECT_THAT(text, HasSubstr("  g_{2} &= m_{l_{2}} l_{2} g c_{12}\n"));
  EXPECT_THAT(text, HasSubstr("- 2 m_{l_{2}} a_{1} l_{2} s_{2} \\dot{q}_{1} \\dot{q}_{2}"));
  EXPECT_THAT(text, HasSubstr("  \\tau_{2} &= (I_{l_{2}} + "));
}

// A planar arm of three parallel joints with numbers.
Robot three_link_planar() {
  Robot robot;
  robot.name = "three_link_planar";
  robot.links.push_back({"base", {}, {}});
  for (int i = 0; i < 3; ++i) {
    const std::string n = std::to_string(i + 1);
    robot.links.push_back(testing::link("link" + n, 2, {GiNaC::numeric(1, 2), 0, 0}, testing::about_z(0)));
    const Pose origin{{testing::translation({i == 0 ? 0 : 1, 0, 0})}, {}};
    robot.joints.push_back(testing::joint("joint" + n, JointType::revolute, i, i + 1, origin, {0, 0, 1}));
  }
  robot.root = 0;
  robot.tip = 3;
  robot.gravity = {0, -10, 0};
  return robot;
}

TEST(DeriveText, SumsOfParallelAnglesWithNumbers) {
  const std::string text = derive_text(make_mechanism(three_link_planar()));
  EXPECT_THAT(text, HasSubstr("\ng_1 = 50 c_1 + 30 c_12 + 10 c_123\n"));
  EXPECT_THAT(text, HasSubstr("\nb_11 = 7.5 + 6 c_2 + 2 c_3 + 2 c_23\n"));
  EXPECT_THAT(text, HasSubstr("\nb_13 = b_31 = 0.5 + c_3 + c_23\n"));
}

TEST(DeriveText, WritesCosinesOutWhereNamesCollide) {
  Robot robot = testing::two_link_planar();
  robot.symbols.front().name = "c_1";  // the symbol m_l1
  const std::string text = derive_text(make_mechanism(robot));
  EXPECT_THAT(text, HasSubstr("\ng_2 = m_l2 l_2 g cos(q_1 + q_2)\n"));
  EXPECT_THAT(text, Not(HasSubstr("cos(q_1),")));
}

TEST(DeriveText, SaysWhatItLeavesOut) {
  DeriveOptions options;
  options.max_terms = 4;
  const std::string text = derive_text(make_mechanism(testing::two_link_planar()), options);
  EXPECT_THAT(text, HasSubstr("\nb_11 = (9 terms, left out)\n"));
  EXPECT_THAT(text, HasSubstr("\nb_22 = I_l2 + m_l2 l_2^2 + k_r2^2 I_m2\n"));
  EXPECT_THAT(text, HasSubstr("\n3 expressions with 37 terms in all are left out: they have more than 4 each\n"));
}

TEST(DeriveText, RefusesLongChains) {
  EXPECT_THROW(derive_text(make_mechanism(testing::random_tree(1, 20, true))), Failure);
}

// c_1 c_2 - s_1 s_2 and similar terms, by a mechanism of three parallel joints.
TEST(AngleRewriter, KnowsWhatIsShorter) {
  const Mechanism mechanism = make_mechanism(three_link_planar());
  const ClosedForm form = closed_form(mechanism);
  const FactorNames names(mechanism, form);
  const AngleRewriter rewriter(mechanism);
  SumFormatter formatter(names, mechanism.size(), Notation::text, 10);
  const auto text = [&](const Number& e) {
    return formatter.text(rewriter.rewritten(names.readable(reduced(e, form))), GroupBy::motion);
  };
  const auto &c = form.c, &s = form.s;
  EXPECT_EQ(text(c[0] * c[1] - s[0] * s[1]), "c_12");
  EXPECT_EQ(text(s[0] * c[1] - c[0] * s[1]), "sin(q_1 - q_2)");
  EXPECT_EQ(text(c[0] * s[1]), "c_1 s_2");
  EXPECT_EQ(text(3 - 3 * c[1] * c[1]), "3 s_2^2");
  EXPECT_EQ(text(c[1] * (c[1] * c[2] - s[1] * s[2])), "c_2 c_23");
  EXPECT_EQ(text(s[1] * (c[1] * c[2] - s[1] * s[2])), "s_2 c_23");
  EXPECT_EQ(text(s[1] * (s[1] * c[2] + c[1] * s[2])), "s_2 s_23");
  EXPECT_EQ(text(5 * (c[0] * c[1] - s[0] * s[1]) * c[2] - 5 * (s[0] * c[1] + c[0] * s[1]) * s[2] - c[0]),
            "-c_1 + 5 c_123");
}

}  // namespace
}  // namespace flatdyn
