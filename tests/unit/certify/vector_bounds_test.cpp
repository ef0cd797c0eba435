// SPDX-License-Identifier: GPL-2.0-or-later
// Bounds of vectors, against observed values and against values known by hand.
#include "proof/certify/vector_bounds.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

namespace flatdyn {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kRounding = 1e-12;

class RandomMatrices {
 public:
  MatrixXd operator()(Eigen::Index rows, Eigen::Index cols) {
    return MatrixXd::NullaryExpr(rows, cols, [this] { return uniform_(engine_); });
  }

 private:
  std::mt19937 engine_{1};
  std::uniform_real_distribution<double> uniform_{-1, 1};
};

double seen_at_all_angles(const MatrixXd& C, const MatrixXd& S, const VectorXd& phi) {
  double largest = 0;
  for (int k = 0; k < 360; ++k) {
    const double angle = k * M_PI / 360;
    largest = std::max(largest, ((std::cos(angle) * C + std::sin(angle) * S) * phi).norm());
  }
  return largest;
}

TEST(OfAnyAngle, IsAsLongAsTheVectorAtEveryAngle) {
  RandomMatrices random;
  for (int k = 0; k < 300; ++k) {
    const Eigen::Index rows = 1 + k % 5, cols = 1 + k % 7;
    MatrixXd C = random(rows, cols), S = random(rows, cols);
    const double size = std::hypot(C.norm(), S.norm());
    C /= size, S /= size;
    const MatrixXd N = bound_over_all_angles(C, S);
    const VectorXd phi = random(cols, 1);
    const double seen = seen_at_all_angles(C, S, phi), bound = (N * phi).norm();
    EXPECT_LE(seen, std::hypot(bound, kNegligibleOfAngles) + kRounding);
    EXPECT_LE(bound, 1.2 * std::hypot((C * phi).norm(), (S * phi).norm()));  // the value that (C, S) could reach
  }
}

// (c x - s y, s x + c y) and, in addition, c z.
TEST(OfAnyAngle, IsNoLongerWhereRowsTurnIntoEachOther) {
  MatrixXd C(3, 3), S(3, 3);
  C << 1, 0, 0, 0, 1, 0, 0, 0, 1;
  S << 0, -1, 0, 1, 0, 0, 0, 0, 0;
  const MatrixXd N = bound_over_all_angles(C, S);
  EXPECT_TRUE((N.transpose() * N).isApprox(MatrixXd::Identity(3, 3), 1e-9));
}

TEST(Gathered, KeepsLengthsAndPutsChosenColumnsInFewRows) {
  RandomMatrices random;
  const MatrixXd chosen = random(6, 2) * random(2, 4) / 10, others = random(6, 3) / 10;
  const GatheredRows rows = gathered(chosen, others);
  EXPECT_EQ(rows.of.rows(), 2);
  EXPECT_LT(rows.lost, kRounding);
  const VectorXd x = random(4, 1), y = random(3, 1);
  const double length = std::hypot((rows.of * x + rows.coupled * y).norm(), (rows.apart * y).norm());
  EXPECT_NEAR(length, (chosen * x + others * y).norm(), kRounding);
}

TEST(RowEchelon, IsTheSameForAllRotationsOfAMatrix) {
  RandomMatrices random;
  const MatrixXd M = random(5, 3) * random(3, 6);
  const MatrixXd Q = Eigen::HouseholderQR<MatrixXd>(random(5, 5)).householderQ();
  const MatrixXd a = row_echelon(M), b = row_echelon(Q * M);
  EXPECT_EQ(a.rows(), 3);
  EXPECT_TRUE(a.isApprox(b, 1e-9));
  EXPECT_TRUE((a.transpose() * a).isApprox(M.transpose() * M, 1e-9));
}

TEST(LengthInBox, IsNotExceededAtCorners) {
  RandomMatrices random;
  for (int k = 0; k < 50; ++k) {
    const MatrixXd M = random(1 + k % 4, 6);
    double largest = 0;
    for (unsigned corner = 0; corner < 64; ++corner) {
      const VectorXd phi =
          VectorXd::NullaryExpr(6, [corner](Eigen::Index i) { return (corner >> i & 1) ? 1.0 : -1.0; });
      largest = std::max(largest, (M * phi).norm());
    }
    EXPECT_LE(largest, length_in_box(M) + kRounding);
    EXPECT_GE(largest, length_in_box(M) / 3);
  }
}

}  // namespace
}  // namespace flatdyn
