// SPDX-License-Identifier: GPL-2.0-or-later
// Rows whose unknown is known: b = 3 exp(-x t) + 2 at some times t, where 3 and 2 are the other parameters.
#include "laboratory/identify/hypothesis.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace flatdyn {
namespace {

using Eigen::VectorXd;

constexpr int kInstants = 40;
constexpr double kRate = 0.7;

VectorXd decay(double rate) { return (VectorXd::LinSpaced(kInstants, 0, 5) * -rate).array().exp(); }

// Decay at an unknown rate. noise: added to the right side, from row to row with another sign.
Hypothesis decay_with(double noise, Unknown rate = {}) {
  return {{rate},
          [noise](const VectorXd& x) {
            WeightedEquations rows{Eigen::MatrixXd::Ones(kInstants, 2),
                                   3 * decay(kRate) + VectorXd::Constant(kInstants, 2)};
            rows.A.col(0) = decay(x[0]);
            for (int k = 0; k < kInstants; ++k) rows.b[k] += k % 2 == 0 ? noise : -noise;
            return rows;
          },
          {VectorXd::Constant(1, 0.1), VectorXd::Constant(1, 4)}};
}

TEST(Hypothesis, FindsTheUnknownAndTheOtherParameters) {
  const HypothesisFit fit = best_fit(decay_with(0));
  EXPECT_NEAR(fit.x[0], kRate, 1e-6);
  EXPECT_NEAR(fit.pi[0], 3, 1e-5);
  EXPECT_NEAR(fit.pi[1], 2, 1e-5);
  EXPECT_LT(fit.cost, 1e-10);
}

TEST(Hypothesis, StaysWithinItsBounds) { EXPECT_NEAR(best_fit(decay_with(0, {.low = 1, .high = 5})).x[0], 1, 1e-6); }

TEST(Hypothesis, KeepsTheNoiseAsItsCost) {
  const HypothesisFit fit = best_fit(decay_with(0.1));
  EXPECT_NEAR(fit.x[0], kRate, 0.05);
  EXPECT_NEAR(fit.cost, kInstants * 0.01, 0.05 * kInstants * 0.01);
}

// The cost grows as the information says, with all other parameters free.
TEST(Hypothesis, HasTheInformationOfItsUnknown) {
  constexpr double kChange = 1e-3;
  const Hypothesis hypothesis = decay_with(0);
  const double information = information_on_unknowns(hypothesis, VectorXd::Constant(1, kRate))(0, 0);
  const double cost = fit_at(hypothesis, VectorXd::Constant(1, kRate + kChange)).cost;
  EXPECT_NEAR(cost, information * kChange * kChange, 0.01 * cost);
}

TEST(Hypothesis, LeavesParametersThatNoRowShowsAtZero) {
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(kInstants, 2);
  A.col(0).setOnes();
  const HypothesisFit fit = fit_of({A, VectorXd::Constant(kInstants, 5)});
  EXPECT_NEAR(fit.pi[0], 5, 1e-8);
  EXPECT_EQ(fit.pi[1], 0);
  EXPECT_NEAR(fit.deviations[0], 1 / std::sqrt(kInstants), 1e-8);
}

}  // namespace
}  // namespace flatdyn
