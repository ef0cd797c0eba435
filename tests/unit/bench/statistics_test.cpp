// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/bench/statistics.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace flatdyn::testing {
namespace {

using ::testing::ElementsAre;

TEST(Quartiles, LieBetweenTheNumbersInOrder) {
  const Quartiles of_five = quartiles({5, 1, 4, 2, 3});
  EXPECT_EQ(of_five.low, 2);
  EXPECT_EQ(of_five.median, 3);
  EXPECT_EQ(of_five.high, 4);
  const Quartiles of_two = quartiles({2, 1});
  EXPECT_EQ(of_two.low, 1.25);
  EXPECT_EQ(of_two.median, 1.5);
  EXPECT_EQ(quartiles({7}).high, 7);
}

TEST(ParetoFront, IsWhatNothingBeats) {
  EXPECT_THAT(pareto_front({{1, 9}, {2, 3}, {3, 3}, {2, 4}, {5, 1}, {6, 1}}),
              ElementsAre(true, true, false, false, true, false));
}

TEST(ParetoFront, HasBothOfTwoEqualOnes) { EXPECT_THAT(pareto_front({{1, 1}, {1, 1}}), ElementsAre(true, true)); }

TEST(FittedExponent, IsThatOfAPowerLaw) {
  std::vector<double> x, y;
  for (const double n : {2.0, 4.0, 8.0, 16.0}) {
    x.push_back(n);
    y.push_back(3 * std::pow(n, 1.75));
  }
  EXPECT_NEAR(fitted_exponent(x, y), 1.75, 1e-12);
}

}  // namespace
}  // namespace flatdyn::testing
