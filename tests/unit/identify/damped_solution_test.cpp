// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/damped_solution.hpp"

#include <gtest/gtest.h>

namespace flatdyn {
namespace {

// The second column is what rounding leaves of a parameter that only a held joint would show; with it, the right side
// asks for a value of 1e14.
TEST(DampedSolution, KeepsTheFilesValueWhereAColumnIsNothingButRounding) {
  Eigen::MatrixXd factor(3, 3);
  factor << 1, 1e-17, 2,  //
      0, 1e-16, 0.01,     //
      0, 0, 0.02;
  const Solution solution = damped_solution(factor, Eigen::Vector2d(0.5, 0.3), 1e-10);
  EXPECT_DOUBLE_EQ(solution.values(0), 2);
  EXPECT_DOUBLE_EQ(solution.values(1), 0.3);
  EXPECT_TRUE(solution.determined[0]);
  EXPECT_FALSE(solution.determined[1]);
  EXPECT_EQ(solution.damped.size(), 1u);
}

}  // namespace
}  // namespace flatdyn
