// SPDX-License-Identifier: GPL-2.0-or-later
#include "functions/deviation/rounding_error_meter.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "graph/function.hpp"

namespace flatdyn::testing {
namespace {

RoundingErrorMeter meter_in(const std::string& scalar) {
  static const Function nothing;
  return {nothing, {}, scalar};
}

TEST(RoundingErrorMeter, MeasuresInLastPlacesOfTheTermsSize) {
  const double eps = std::numeric_limits<double>::epsilon();
  const EntryTruth<long double> truth{{1, 2}, {8, 2}};
  const RoundingError error = meter_in("double").error({1 + 4 * eps, 2}, truth);
  EXPECT_EQ(error.scaled, 0.5);
  EXPECT_EQ(error.condition, 8);
  EXPECT_EQ(error.relative, 4);
}

TEST(RoundingErrorMeter, CountsInTheLastPlacesOfFloat) {
  const double eps = std::numeric_limits<float>::epsilon();
  EXPECT_EQ(meter_in("float").error({1 + eps}, EntryTruth<long double>{{1}, {1}}).scaled, 1);
}

TEST(RoundingErrorMeter, TakesAnEntryWithoutTermsForZeroToTheLastBit) {
  const EntryTruth<Real50> truth{{Real50(0)}, {0}};
  EXPECT_EQ(meter_in("double").error({0}, truth).scaled, 0);
  EXPECT_EQ(meter_in("double").error({1e-300}, truth).scaled, std::numeric_limits<double>::infinity());
}

TEST(RoundingErrorMeter, TakesWhatIsNoNumberForInfinitelyWrong) {
  const EntryTruth<long double> truth{{1}, {1}};
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(meter_in("double").error({nan}, truth).scaled, inf);
  EXPECT_EQ(meter_in("double").error({inf}, truth).scaled, inf);
}

TEST(RoundingErrorMeter, ForgivesDigitsLostBelowTheSmallestNormalNumber) {
  const EntryTruth<long double> truth{{0}, {1e-320}};
  EXPECT_LE(meter_in("double").error({5e-324}, truth).scaled, 1);
}

}  // namespace
}  // namespace flatdyn::testing
