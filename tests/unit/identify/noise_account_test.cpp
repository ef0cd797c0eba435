// SPDX-License-Identifier: GPL-2.0-or-later
// Logs in which the encoder's noise is not small against the motion, and joints that hardly move: what is told holds
// within its intervals, and the rest is not told.
#include "laboratory/identify/noise_account.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <limits>

#include "support/practical_bench.hpp"

namespace flatdyn {
namespace {

using testing::kEncoderStep;
using testing::SimulatedSample;
using Bench = testing::PracticalBench;

class NoiseAccount : public ::testing::Test {
 protected:
  static constexpr int kTiny = 3;  // the joint that moves little
  Bench& bench = testing::ur5();

  Measurement with_tiny_joint(double scale) {
    return bench.measured(bench.motion({.seconds = 12, .scale = {1, 1, 1, scale, 1, 1}}), kEncoderStep, 1);
  }
  void expect_honest(const Estimate& found) const {
    constexpr double kFar = 4.5;  // standard deviations
    for (int k = 0; k < bench.model().parameters(); ++k) {
      if (std::isinf(found.standard_deviations(k))) continue;
      EXPECT_NEAR(found.values(k), bench.truth(k), kFar * found.standard_deviations(k))
          << parameter_name(bench.model().base().columns[static_cast<std::size_t>(k)]);
    }
  }
  bool is_told(const Estimate& found, const char* name) const {
    return std::isfinite(found.standard_deviations(bench.place_of(name)));
  }
};

// Half a hundred steps of the encoder: the acceleration that the filter finds is noise.
TEST_F(NoiseAccount, DoesNotTellTheRotorOfAJointThatMovesByFewSteps) {
  const Measurement measurement = with_tiny_joint(0.01);
  EXPECT_GT(measurement.observations.joints[kTiny].rows, 40);
  const Estimate found = bench.estimated(measurement);
  expect_honest(found);
  EXPECT_FALSE(is_told(found, "Im4"));
  EXPECT_TRUE(is_told(found, "Fs4"));
  EXPECT_TRUE(is_told(found, "Im3"));
  EXPECT_TRUE(found.noisy.back().is_open());
}

TEST_F(NoiseAccount, LeavesOutTheFewRowsOfAJointThatHardlyMoves) {
  const Measurement measurement = with_tiny_joint(0.0025);
  const JointObservations& joint = measurement.observations.joints[kTiny];
  EXPECT_EQ(joint.rows, 0);
  EXPECT_GT(joint.left_out, 0);
  const Estimate found = bench.estimated(measurement);
  expect_honest(found);
  EXPECT_FALSE(is_told(found, "Fs4"));
}

// The bias that noise of q makes is as large as the information: what is taken off has to be right.
TEST_F(NoiseAccount, HoldsForASlowMotionAtALowRate) {
  const std::vector<SimulatedSample> samples = bench.motion({.seconds = 60, .rate = 200, .fundamental = 0.02});
  for (const double band : {10.0, 5.0}) {
    const Estimate found = bench.estimated(bench.measured(samples, kEncoderStep, 1, 1, {.band = band}));
    expect_honest(found);
    EXPECT_GT(found.noisy.back().share, 0.15) << band;
  }
  const Measurement measurement = bench.measured(samples, kEncoderStep, 1);
  EXPECT_LT(measurement.logs[0].filter.band, 7);
  const Estimate found = bench.estimated(measurement);
  expect_honest(found);
  EXPECT_TRUE(found.standard_deviations.allFinite());
}

TEST_F(NoiseAccount, FindsNoNoiseWorthTheNameInASoundLog) {
  const Estimate found = bench.estimated(bench.measured(bench.motion({.seconds = 12}), kEncoderStep, 1));
  EXPECT_LT(found.noisy.back().share, 0.05);
  EXPECT_TRUE(found.standard_deviations.allFinite());
}

// Torques that look like noise of a joint's acceleration are misfit where its positions have no such noise.
TEST_F(NoiseAccount, IsNoMoreThanPositionsShowAboveTheBand) {
  constexpr Eigen::Index kJoint = 2;
  Observations observations = bench.measured(bench.motion({.seconds = 12}), 1e-5, 1).observations;
  Eigen::VectorXd values(bench.model().parameters());
  for (int k = 0; k < values.size(); ++k) values[k] = bench.truth(k);
  const AccelerationRows rows = bench.acceleration_rows();
  const std::vector<Eigen::MatrixXd> B = inertias(observations, values, rows);
  testing::Uniform draw(4);
  for (std::size_t t = 0; t < B.size(); ++t) {
    const double error = 3 * draw.normal();
    for (Eigen::Index i = 0; i < B[t].rows(); ++i) {
      observations.instants[t].right[static_cast<std::size_t>(i)] += B[t](i, kJoint) * error;
    }
  }
  const auto n = static_cast<Eigen::Index>(observations.joints.size());
  const FitGain nothing{Eigen::MatrixXd::Zero(values.size(), 0), Eigen::VectorXd::Ones(n), Eigen::VectorXd::Ones(n)};
  const auto variance = [&] {
    return NoiseSearch(NoiseStructure(observations), nothing, rows).noise_of(values).acceleration[kJoint];
  };
  std::vector<double>& most = observations.shapes[0].most_of_accelerations;
  const double bounded = variance();
  EXPECT_LE(bounded, most[kJoint] * (1 + 1e-9));
  std::fill(most.begin(), most.end(), std::numeric_limits<double>::infinity());
  EXPECT_GT(variance(), 10 * bounded);
}

}  // namespace
}  // namespace flatdyn
