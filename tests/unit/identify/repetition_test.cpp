// SPDX-License-Identifier: GPL-2.0-or-later
// Motions that are logged more than once are found, and what repeats with them is told from noise.
#include "laboratory/identify/repetition.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/practical_bench.hpp"

namespace flatdyn {
namespace {

using Bench = testing::PracticalBench;

class RepetitionTest : public ::testing::Test {
 protected:
  Measurement measured(const testing::PracticalOptions& options, unsigned seed = 1) {
    return bench.measured(bench.motion(options), testing::kEncoderStep, 1, seed);
  }
  double seconds_of(const RepeatedMotion& motion, const Measurement& measurement) const {
    const SampleFilter& filter = measurement.logs[static_cast<std::size_t>(motion.log)].filter;
    return motion.period * filter.dt * filter.decimate;
  }

  Bench& bench = testing::ur5();
};

TEST_F(RepetitionTest, FindsThePeriodOfAMotion) {
  const Measurement measurement = measured({.seconds = 27, .fundamental = 0.13});
  const Repetition found = repetition_of(measurement.observations);
  ASSERT_EQ(found.motions.size(), 1U);
  EXPECT_TRUE(found.motions[0].begins_anew);
  EXPECT_NEAR(seconds_of(found.motions[0], measurement), 1 / 0.13, 0.01);
  EXPECT_NEAR(found.motions[0].count, 25.5 * 0.13, 0.1);  // without the ends, which the filter takes
  const std::vector<EquationInstant>& instants = measurement.observations.instants;
  for (std::size_t t = 0; t < instants.size(); ++t) {
    const double rows = static_cast<double>(instants[t].index - instants[0].index);
    EXPECT_NEAR(std::remainder(found.phase_of[t] - rows, found.motions[0].period), 0, 1e-6);
  }
}

TEST_F(RepetitionTest, FindsNoneInAMotionThatIsLoggedOnce) {
  const Repetition found = repetition_of(measured({.seconds = 20, .fundamental = 0.05}).observations);
  ASSERT_EQ(found.motions.size(), 1U);
  EXPECT_FALSE(found.motions[0].begins_anew);
  EXPECT_FALSE(found.any());
}

// Two logs of one motion, the second of which begins later, and one of another motion.
TEST_F(RepetitionTest, FindsAMotionInAnotherLog) {
  constexpr long kLater = 1500;  // samples
  Observations all;
  for (int log = 0; log < 3; ++log) {
    std::vector<testing::SimulatedSample> samples = bench.motion({.motion = log == 2 ? 2U : 1U, .fundamental = 0.05});
    if (log == 1) samples.erase(samples.begin(), samples.begin() + kLater);
    Observations own = bench.measured(samples, testing::kEncoderStep, 1, static_cast<unsigned>(log + 1)).observations;
    for (EquationInstant& each : own.instants) each.log = log;
    all.instants.insert(all.instants.end(), own.instants.begin(), own.instants.end());
    all.shapes.push_back(own.shapes[0]);
    if (log == 0) all.joints = own.joints;
  }
  const Repetition found = repetition_of(all);
  ASSERT_EQ(found.motions.size(), 2U);
  EXPECT_NEAR(found.motions[0].count, 1.92, 0.05);
  EXPECT_NEAR(found.motions[1].count, 1, 1e-9);
  const std::size_t first_of_second =
      static_cast<std::size_t>(std::find_if(all.instants.begin(), all.instants.end(),
                                            [](const EquationInstant& each) { return each.log == 1; }) -
                               all.instants.begin());
  const std::vector<double>& phases = found.phase_of;
  EXPECT_NEAR(phases[first_of_second], phases[0] + 1e-3 * kLater / (all.instants[1].time - all.instants[0].time), 1.5);
}

// The arm rests at one place before its motion and after it: that is no repetition.
TEST_F(RepetitionTest, FindsNoneInRests) {
  std::vector<testing::SimulatedSample> samples = bench.motion({.seconds = 8, .fundamental = 0.125});
  const std::vector<testing::SimulatedSample> rest(2500, samples.front());
  samples.insert(samples.begin(), rest.begin(), rest.end());
  samples.insert(samples.end(), rest.begin(), rest.end());
  for (std::size_t k = 0; k < samples.size(); ++k) samples[k].time = 1e-3 * static_cast<double>(k);
  EXPECT_FALSE(repetition_of(bench.measured(samples, testing::kEncoderStep, 1).observations).any());
}

// Where not all instants are kept, the period is found, too, and deviations do not fall with the number of repetitions.
TEST_F(RepetitionTest, HoldsForLongLogs) {
  const auto deviation = [&](double seconds) {
    std::vector<testing::SimulatedSample> samples = bench.motion({.seconds = seconds, .fundamental = 0.125});
    for (testing::SimulatedSample& each : samples) {
      for (Eigen::Index i = 0; i < 6; ++i) each.tau(i) += 2 * std::sin(19 * each.q(i));
    }
    const Measurement measurement = bench.measured(samples, 0, 0.1, 1, {.band = 10});
    const Repetition found = repetition_of(measurement.observations);
    EXPECT_NEAR(seconds_of(found.motions.at(0), measurement), 8, 0.1) << seconds;
    EXPECT_NEAR(found.motions.at(0).count, seconds / 8, 0.1 * seconds / 8 + 0.3) << seconds;
    return bench.estimated(measurement).standard_deviations(bench.place_of("Fs1"));
  };
  const double of_three = deviation(24), of_twenty = deviation(160);
  EXPECT_GT(of_twenty, 0.7 * of_three);
  EXPECT_LT(of_twenty, 1.4 * of_three);
}

// The variances of noise that a motion of known residuals has: white, and the same at each repetition.
TEST_F(RepetitionTest, WhatRepeatsIsToldFromNoise) {
  Observations observations = measured({.seconds = 40}).observations;
  const NoiseStructure structure(observations);
  ASSERT_TRUE(structure.has_repetition());
  const Repetition repetition = repetition_of(observations);
  const Eigen::VectorXd values = Eigen::VectorXd::Zero(observations.parameters);
  testing::Uniform draw(5);
  std::vector<double> of_phase;
  for (int k = 0; k < 1000; ++k) of_phase.push_back(draw());
  for (std::size_t t = 0; t < observations.instants.size(); ++t) {
    for (double& each : observations.instants[t].right) each = draw();
    observations.instants[t].right[0] += 3 * of_phase[static_cast<std::size_t>(std::lround(repetition.phase_of[t]))];
  }
  const auto n = static_cast<Eigen::Index>(observations.joints.size());
  const FitGain nothing{Eigen::MatrixXd::Zero(observations.parameters, 0), Eigen::VectorXd::Ones(n),
                        Eigen::VectorXd::Ones(n)};
  const ResidualNoise noise = NoiseSearch(structure, nothing, nullptr).noise_of(values);
  const Eigen::Index kinds = noise.torques.cols() / 2;
  const double repeated = noise.torques.row(0).tail(kinds).sum(), other = noise.torques.row(0).head(kinds).sum();
  EXPECT_NEAR(repeated / (repeated + other), 0.9, 0.1);
  for (Eigen::Index i = 1; i < n; ++i) {
    EXPECT_LT(noise.torques.row(i).tail(kinds).sum(), 0.1 * noise.torques.row(i).head(kinds).sum()) << i;
  }
}

}  // namespace
}  // namespace flatdyn
