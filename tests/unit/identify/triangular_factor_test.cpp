// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/triangular_factor.hpp"

#include <gtest/gtest.h>

namespace flatdyn {
namespace {

Eigen::MatrixXd random_rows(int rows, int columns) {
  std::srand(7);
  return Eigen::MatrixXd::Random(rows, columns);
}

TriangularFactor folded(const Eigen::MatrixXd& rows) {
  TriangularFactor factor(static_cast<int>(rows.cols()) - 1);
  for (Eigen::Index k = 0; k < rows.rows(); ++k) factor.next_row() = rows.row(k);
  return factor;
}

// Checks Rᵀ R = [A b]ᵀ [A b] and that R is triangular.
void expect_factor_of(const Eigen::MatrixXd& R, const Eigen::MatrixXd& rows) {
  EXPECT_TRUE(R.isUpperTriangular(0));
  EXPECT_LT((R.transpose() * R - rows.transpose() * rows).norm(), 1e-12 * rows.squaredNorm());
}

TEST(TriangularFactor, HoldsRowsOfAnyNumber) {
  for (const int count : {1, 5, 300, 5000}) {
    const Eigen::MatrixXd rows = random_rows(count, 13);
    TriangularFactor factor = folded(rows);
    expect_factor_of(factor.factor(), rows);
    EXPECT_EQ(factor.count(), count);
  }
}

TEST(TriangularFactor, OfPartsJoinedIsThatOfTheWhole) {
  const Eigen::MatrixXd rows = random_rows(2000, 9);
  TriangularFactor first = folded(rows.topRows(700)), second = folded(rows.bottomRows(1300));
  first.join(second.factor(), second.count());
  expect_factor_of(first.factor(), rows);
  EXPECT_EQ(first.count(), 2000);
}

TEST(TriangularFactor, GoesOnAfterItWasRead) {
  const Eigen::MatrixXd rows = random_rows(400, 4);
  TriangularFactor factor(3);
  for (Eigen::Index k = 0; k < rows.rows(); ++k) {
    factor.next_row() = rows.row(k);
    if (k % 50 == 0) factor.factor();
  }
  expect_factor_of(factor.factor(), rows);
}

}  // namespace
}  // namespace flatdyn
