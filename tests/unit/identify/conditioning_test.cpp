// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/conditioning.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

namespace flatdyn::testing {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd some_matrix() {
  MatrixXd matrix(6, 3);
  matrix << 1, 2, 0.5, -3, 1, 0, 0.25, 4, 1, 2, -1, 3, 0.5, 0.5, -2, 1, 0, 1;
  return matrix;
}

// Columns at an angle φ: the singular values of [[1, cos φ], [0, sin φ]] are √(1 ± cos φ).
TEST(Conditioning, IsThatOfTheColumnsAtUnitLength) {
  const double angle = 0.3;
  MatrixXd matrix = MatrixXd::Zero(4, 2);
  matrix(1, 0) = 1000;
  matrix(1, 1) = 0.01 * std::cos(angle);
  matrix(3, 1) = 0.01 * std::sin(angle);
  const Conditioning result = conditioning(matrix, VectorXd{{1000, 0.01}});
  EXPECT_NEAR(result.scaled, std::sqrt((1 + std::cos(angle)) / (1 - std::cos(angle))), 1e-12);
  EXPECT_NEAR(result.relative, result.scaled, 1e-12);
  EXPECT_GT(result.unscaled, 1e5);
  // The two columns are similar, so their difference is least visible.
  EXPECT_NEAR(std::abs(result.weakest(0)), std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(result.weakest(0), -result.weakest(1), 1e-12);
}

// A column a hundredth as long as in other motions counts as such; unit length would hide it.
TEST(Conditioning, KnowsColumnsThatAreShorterThanElsewhere) {
  MatrixXd matrix = MatrixXd::Identity(3, 2);
  matrix(1, 1) = 0.01;
  const Conditioning result = conditioning(matrix, VectorXd{{1, 1}});
  EXPECT_NEAR(result.relative, 100, 1e-9);
  EXPECT_NEAR(result.scaled, 1, 1e-12);
  EXPECT_NEAR(std::abs(result.weakest(1)), 1, 1e-12);
}

// YᵀY would have none of these digits.
TEST(Conditioning, SurvivesConditionNumbersBeyondTheRootOfPrecision) {
  MatrixXd matrix = MatrixXd::Identity(5, 3);
  matrix.col(1) = matrix.col(0);
  matrix(4, 1) = 1e-10;
  EXPECT_NEAR(conditioning(matrix, VectorXd::Ones(3)).scaled, 2e10, 1e5);
}

TEST(ExcitationCost, IsOfStandardDeviationsAndTheLargestSingularValue) {
  const MatrixXd matrix = some_matrix(), covariance = (matrix.transpose() * matrix).inverse();
  const double largest = Eigen::JacobiSVD<MatrixXd>(matrix).singularValues()(0);
  const double exact = std::log(covariance.trace() / 3) / 2 + std::log(largest) / 4;
  EXPECT_GE(excitation_cost(matrix, nullptr), exact);
  EXPECT_LT(excitation_cost(matrix, nullptr), exact + 0.02);
  const VectorXd deviations = conditioning(matrix, VectorXd{{3, 0.1, 7}}).standard_deviations;
  EXPECT_LT((deviations - covariance.diagonal().cwiseSqrt()).norm(), 1e-12 * deviations.norm());
}

TEST(ExcitationCost, SlopeIsTheDerivative) {
  MatrixXd matrix = some_matrix(), slope;
  excitation_cost(matrix, &slope);
  constexpr double kStep = 1e-6;
  for (Eigen::Index k = 0; k < matrix.size(); ++k) {
    const double here = matrix(k);
    matrix(k) = here + kStep;
    const double above = excitation_cost(matrix, nullptr);
    matrix(k) = here - kStep;
    const double below = excitation_cost(matrix, nullptr);
    matrix(k) = here;
    EXPECT_NEAR(slope(k), (above - below) / (2 * kStep), 1e-8) << k;
  }
}

}  // namespace
}  // namespace flatdyn::testing
