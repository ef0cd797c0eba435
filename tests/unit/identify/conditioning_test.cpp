// SPDX-License-Identifier: GPL-2.0-or-later
#include "identify/conditioning.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace flatdyn::testing {
namespace {

using Eigen::MatrixXd;

MatrixXd some_matrix() {
  MatrixXd matrix(6, 3);
  matrix << 1, 2, 0.5, -3, 1, 0, 0.25, 4, 1, 2, -1, 3, 0.5, 0.5, -2, 1, 0, 1;
  return matrix;
}

// Columns c, s and (1, 1)/√2-like: singular values of [[1, cos φ], [0, sin φ]] are √(1 ± cos φ).
TEST(Conditioning, IsThatOfTheColumnsAtUnitLength) {
  const double angle = 0.3;
  MatrixXd matrix = MatrixXd::Zero(4, 2);
  matrix(1, 0) = 1000;
  matrix(1, 1) = 0.01 * std::cos(angle);
  matrix(3, 1) = 0.01 * std::sin(angle);
  const Conditioning result = conditioning(matrix);
  EXPECT_NEAR(result.scaled, std::sqrt((1 + std::cos(angle)) / (1 - std::cos(angle))), 1e-12);
  EXPECT_GT(result.unscaled, 1e5);
  // The two columns are alike, so their difference shows least.
  EXPECT_NEAR(std::abs(result.weakest(0)), std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(result.weakest(0), -result.weakest(1), 1e-12);
}

// YᵀY would have none of these digits.
TEST(Conditioning, SurvivesConditionNumbersBeyondTheRootOfPrecision) {
  MatrixXd matrix = MatrixXd::Identity(5, 3);
  matrix.col(1) = matrix.col(0);
  matrix(4, 1) = 1e-10;
  EXPECT_NEAR(conditioning(matrix).scaled, 2e10, 1e5);
}

TEST(SmoothLogCondition, IsALittleAboveTheLogarithm) {
  const double exact = std::log(conditioning(some_matrix()).scaled);
  const double smooth = smooth_log_condition(some_matrix(), nullptr);
  EXPECT_GE(smooth, exact);
  EXPECT_LT(smooth, exact + 0.1);
}

TEST(SmoothLogCondition, SlopeIsTheDerivative) {
  MatrixXd matrix = some_matrix(), slope;
  smooth_log_condition(matrix, &slope);
  constexpr double kStep = 1e-6;
  for (Eigen::Index k = 0; k < matrix.size(); ++k) {
    const double here = matrix(k);
    matrix(k) = here + kStep;
    const double above = smooth_log_condition(matrix, nullptr);
    matrix(k) = here - kStep;
    const double below = smooth_log_condition(matrix, nullptr);
    matrix(k) = here;
    EXPECT_NEAR(slope(k), (above - below) / (2 * kStep), 1e-8) << k;
  }
}

}  // namespace
}  // namespace flatdyn::testing
