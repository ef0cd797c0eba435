// SPDX-License-Identifier: GPL-2.0-or-later
// Problems of the textbook's chapter that are about formulas rather than a command: docs/problems/.
#include <gtest/gtest.h>

#include "derivation/closed_form/closed_form.hpp"
#include "functions/planning/make_functions.hpp"
#include "support/robot_models.hpp"
#include "symbolic/textbook_robots.hpp"

namespace flatdyn {
namespace {

// ∂f/∂q_k of a polynomial in the sines and cosines of the joints.
Number slope(const Number& f, int k, const ClosedForm& form) {
  const GiNaC::symbol &c = form.c[at(k)], &s = form.s[at(k)];
  return f.diff(s) * c - f.diff(c) * s;
}

// Both matrices C of the two-link planar arm, and wᵀ (Ḃ - 2 C) w.
struct TwoMatrices {
  Mechanism mechanism = make_mechanism(testing::two_link_planar());
  ClosedForm form = closed_form(mechanism);
  std::vector<Number> qd = {GiNaC::symbol("qd_1"), GiNaC::symbol("qd_2")};
  Rows symmetric = Rows(2, std::vector<Number>(2, 0)), plain = symmetric, dB = symmetric;

  TwoMatrices() {
    for (int i = 0; i < 2; ++i) {
      for (int j = 0; j < 2; ++j) {
        for (int k = 0; k < 2; ++k) {
          symmetric[at(i)][at(j)] += form.christoffel(i, j, k) * qd[at(k)];
          plain[at(i)][at(j)] +=
              (slope(form.B[at(i)][at(j)], k, form) - slope(form.B[at(j)][at(k)], i, form) / 2) * qd[at(k)];
          dB[at(i)][at(j)] += slope(form.B[at(i)][at(j)], k, form) * qd[at(k)];
        }
      }
    }
  }

  Number quadratic(const Rows& C, const std::vector<Number>& w) const {
    Number sum = 0;
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t j = 0; j < 2; ++j) sum += w[i] * (dB[i][j] - 2 * C[i][j]) * w[j];
    }
    return reduced(sum, form);
  }
  Number torque(const Rows& C, std::size_t i) const { return reduced(C[i][0] * qd[0] + C[i][1] * qd[1], form); }
};

// (7.49) holds for any choice of C, (7.48) only for that of the Christoffel symbols.
TEST(Problems, P7_2) {
  const TwoMatrices arm;
  for (std::size_t i = 0; i < 2; ++i) EXPECT_TRUE((arm.torque(arm.symmetric, i) - arm.torque(arm.plain, i)).is_zero());
  EXPECT_TRUE(arm.quadratic(arm.symmetric, arm.qd).is_zero());
  EXPECT_TRUE(arm.quadratic(arm.plain, arm.qd).is_zero());
  const std::vector<Number> w = {GiNaC::symbol("w_1"), GiNaC::symbol("w_2")};
  EXPECT_TRUE(arm.quadratic(arm.symmetric, w).is_zero());
  const Number h = -testing::symbol(arm.mechanism, "m_l2") * testing::symbol(arm.mechanism, "a_1") *
                   testing::symbol(arm.mechanism, "l_2") * arm.form.s[1];
  EXPECT_TRUE((arm.quadratic(arm.plain, {1, 0}) + 2 * h * arm.qd[1]).expand().is_zero());
}

// Y π of Problem 7.5 is the derived model with the payload.
TEST(Problems, P7_5) {
  PipelineOptions options;
  options.read.scene_file = FLATDYN_SOURCE_DIR "/docs/problems/tip_payload.toml";
  const LoadedRobot model = load_robot(FLATDYN_SOURCE_DIR "/robots/prismatic_revolute.toml", options);
  const ClosedForm form = closed_form(model.mechanism);
  const auto p = [&](const char* name) { return testing::symbol(model.mechanism, name); };
  const Number pi_1 = p("m_L") + p("m_l1") + p("m_l2") + p("m_m2") + p("k_r1") * p("k_r1") * p("I_m1");
  const Number pi_2 = p("m_L") * p("a_2") + p("m_l2") * p("l_2");
  const Number pi_3 =
      p("m_L") * p("a_2") * p("a_2") + p("I_l2") + p("m_l2") * p("l_2") * p("l_2") + p("k_r2") * p("k_r2") * p("I_m2");
  const Number c = form.c[1], s = form.s[1];
  const auto is_zero = [&](const Number& difference) { return reduced(difference, form).is_zero(); };
  EXPECT_TRUE(is_zero(form.B[0][0] - pi_1));
  EXPECT_TRUE(is_zero(form.B[0][1] + s * pi_2));
  EXPECT_TRUE(is_zero(form.B[1][1] - pi_3));
  EXPECT_TRUE(is_zero(form.christoffel(0, 1, 1) + c * pi_2));
  EXPECT_TRUE(is_zero(form.g[0]));
  EXPECT_TRUE(is_zero(form.g[1] - c * p("g") * pi_2));
}

}  // namespace
}  // namespace flatdyn
