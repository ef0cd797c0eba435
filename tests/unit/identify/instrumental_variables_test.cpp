// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/instrumental_variables.hpp"

#include <gtest/gtest.h>

#include "laboratory/identify/identification.hpp"
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
    TorqueEquations equations(bench.model());
    equations.set_instruments();
    InstrumentSums sums(equations);
    const Measurement measurement = bench.measured(samples, step, noise, seed, {}, &equations, nullptr,
                                                   [&](const FilteredEquations& each, int) { sums.add(each); });
    EstimateOptions options;
    options.acceleration_rows = equations.acceleration_rows();
    result.by_instruments = sums.estimate(measurement.observations, equations.file_values(), options);
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

// A motion that is simulated under the measured torques would have their noise: of its intervals three in four hold the
// truth.
TEST_F(InstrumentalVariables, HaveIntervalsThatHoldTheTruth) {
  int inside = 0, all = 0;
  for (unsigned motion = 1; motion <= 5; ++motion) {
    const Estimate found =
        estimated(bench.motion({.seconds = 12, .motion = motion}), testing::kEncoderStep, 1, motion).by_instruments;
    for (int k = 0; k < bench.model().parameters(); ++k) {
      inside += std::abs(found.values(k) - bench.truth(k)) < 1.96 * found.standard_deviations(k) ? 1 : 0;
      ++all;
    }
  }
  EXPECT_GT(inside, 0.92 * all);
  EXPECT_LT(inside, 0.98 * all);
}

// A held joint and one that moves little: where least squares tells nothing, the instruments must not either.
TEST_F(InstrumentalVariables, AreFiniteWhereJointsHardlyMove) {
  const Estimates found =
      estimated(bench.motion({.seconds = 6, .held = {1}, .scale = {1, 1, 1, 0.02, 1, 1}}), 1e-3, 0.3);
  EXPECT_TRUE(found.by_instruments.values.allFinite());
  EXPECT_TRUE(found.by_instruments.covariance.allFinite());
  EXPECT_TRUE(std::isinf(found.by_instruments.standard_deviations(bench.place_of("Fs2"))));
}

// Steps of 3e-3 rad, thirty times those of a usual encoder. What they do is taken off least squares by a model of
// noise; the instruments need none.
TEST_F(InstrumentalVariables, HoldWherePositionsAreVeryNoisy) {
  constexpr double kCoarse = 3e-3;
  const Estimates found = estimated(bench.motion({.motion = 2}), kCoarse, 1);
  EXPECT_LT(error_of(found.by_instruments), 1.4);
  EXPECT_LT(error_of(found.least_squares), 1.6);
}

}  // namespace
}  // namespace flatdyn
