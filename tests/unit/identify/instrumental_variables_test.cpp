// SPDX-License-Identifier: GPL-2.0-or-later
#include "identify/instrumental_variables.hpp"

#include <gtest/gtest.h>

#include "identify/identification.hpp"
#include "support/practical_bench.hpp"

namespace flatdyn {
namespace {

using testing::SimulatedSample;
using Bench = testing::PracticalBench;

class InstrumentalVariables : public ::testing::Test {
 protected:
  Bench& bench = testing::ur5();

  struct Estimates {
    Estimate least_squares, by_instruments;
  };
  Estimates estimated(const std::vector<SimulatedSample>& samples, double step, double noise, unsigned seed = 1) {
    Estimates result;
    result.least_squares = bench.estimated(bench.measured(samples, step, noise, seed));
    result.by_instruments = result.least_squares;
    for (int round = 0; round < 2; ++round) {
      TorqueEquations equations(bench.model());
      equations.set_instrument(result.by_instruments.values);
      InstrumentSums sums(equations);
      const Measurement measurement = bench.measured(samples, step, noise, seed, {}, &equations, nullptr,
                                                     [&](const FilteredEquations& each, int) { sums.add(each); });
      result.by_instruments =
          sums.estimate(measurement.observations, result.least_squares, equations.acceleration_rows());
    }
    return result;
  }
  // The root mean square of the errors in standard deviations: 1 for honest intervals.
  double error_of(const Estimate& found) const {
    double squares = 0;
    const auto b = bench.model().parameters();
    for (int k = 0; k < b; ++k) {
      squares += std::pow((found.values(k) - bench.truth(k)) / found.standard_deviations(k), 2);
    }
    return std::sqrt(squares / b);
  }
};

TEST_F(InstrumentalVariables, FindEveryParameterOfALogWithoutNoise) {
  const Estimates found = estimated(bench.motion({}), 0, 0);
  for (int k = 0; k < bench.model().parameters(); ++k) {
    EXPECT_NEAR(found.by_instruments.values(k), bench.truth(k), 1e-4) << k;
  }
}

TEST_F(InstrumentalVariables, HaveHonestIntervals) {
  const Estimates found = estimated(bench.motion({}), testing::kEncoderStep, 1);
  EXPECT_LT(error_of(found.by_instruments), 1.3);
  EXPECT_GT(error_of(found.by_instruments), 0.75);
}

// Steps of 3e-3 rad, thirty times those of a usual encoder, are beyond what the compensation of least squares holds
// for.
TEST_F(InstrumentalVariables, HoldWherePositionsAreVeryNoisy) {
  constexpr double kCoarse = 3e-3;
  const Estimates found = estimated(bench.motion({.motion = 2}), kCoarse, 1);
  EXPECT_LT(error_of(found.by_instruments), 0.7 * error_of(found.least_squares));
  EXPECT_LT(error_of(found.by_instruments), 2);
}

}  // namespace
}  // namespace flatdyn
