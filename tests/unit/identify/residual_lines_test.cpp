// SPDX-License-Identifier: GPL-2.0-or-later
// Ripple of gears, a resonance, and friction that falls while the arm warms up are named; sound logs have none of them.
#include "laboratory/identify/residual_lines.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/identification_report.hpp"
#include "support/practical_bench.hpp"

namespace flatdyn {
namespace {

using testing::SimulatedSample;

class ResidualLinesTest : public ::testing::Test {
 protected:
  static constexpr int kJoint = 2;

  template <class Change>
  Eigen::MatrixXd residuals_of(const Change& change) {
    std::vector<SimulatedSample> samples = bench.motion({.fundamental = 0.05});
    for (std::size_t k = 0; k < samples.size(); ++k) change(1e-3 * static_cast<double>(k), samples[k]);
    measurement = bench.measured(samples, testing::kEncoderStep, 0.3);
    estimate = bench.estimated(measurement);
    return residuals(measurement.observations, estimate.values);
  }
  std::optional<ResidualLine> line(const Eigen::MatrixXd& left, int joint) const {
    return residual_line(measurement.observations, left.col(joint), joint, false, {measurement.logs[0].filter.band});
  }
  std::optional<ResidualLine> ripple(int joint) const {
    const SampleFilter& filter = measurement.logs[0].filter;
    return fast_ripple(measurement.observations, joint, joint, false, {filter.band}, {1 / filter.dt});
  }
  std::optional<FrictionChange> change_of(const Eigen::MatrixXd& left, int joint) const {
    const auto number = std::to_string(joint + 1);
    return friction_change(measurement.observations, left.col(joint), joint,
                           estimate.values(bench.place_of("Fv" + number)),
                           estimate.values(bench.place_of("Fs" + number)), 0,
                           measurement.observations.joints[static_cast<std::size_t>(joint)].correlation);
  }

  testing::PracticalBench& bench = testing::ur5();
  Measurement measurement;
  Estimate estimate;
};

TEST_F(ResidualLinesTest, AreNotInASoundLog) {
  const Eigen::MatrixXd left = residuals_of([](double, SimulatedSample&) {});
  for (int joint = 0; joint < 6; ++joint) {
    EXPECT_FALSE(line(left, joint)) << joint;
    EXPECT_FALSE(change_of(left, joint)) << joint;
  }
}

TEST_F(ResidualLinesTest, FindRippleByTheTurnsOfTheJoint) {
  const Eigen::MatrixXd left = residuals_of(
      [](double, SimulatedSample& each) { each.tau(kJoint) += 1.5 * std::sin(50.5 * each.q(kJoint) + 1); });
  const std::optional<ResidualLine> found = line(left, kJoint);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->is_of_turns);
  EXPECT_NEAR(found->rate, 50.5, 0.3);
  EXPECT_NEAR(found->amplitude, 1.5, 0.6);
  EXPECT_FALSE(line(left, 0));
}

// At 0.5 rad/s it has 24 Hz, and the band is 10 Hz: residuals have nothing of it.
TEST_F(ResidualLinesTest, FindRippleFasterThanTheBandInWhatTheFilterTakesAway) {
  const Eigen::MatrixXd left = residuals_of(
      [](double, SimulatedSample& each) { each.tau(kJoint) += 0.4 * std::sin(300.25 * each.q(kJoint) + 1); });
  const std::optional<ResidualLine> found = ripple(kJoint);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->rate, 300.25, 0.5);
  EXPECT_NEAR(found->amplitude, 0.4, 0.05);
  EXPECT_FALSE(line(left, kJoint));
  for (const int joint : {0, 1, 3, 4, 5}) EXPECT_FALSE(ripple(joint)) << joint;
}

TEST_F(ResidualLinesTest, FindAResonanceByItsFrequency) {
  const Eigen::MatrixXd left = residuals_of(
      [](double t, SimulatedSample& each) { each.tau(kJoint) += 1.5 * std::sin(2 * std::numbers::pi * 3.1 * t); });
  const std::optional<ResidualLine> found = line(left, kJoint);
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->is_of_turns);
  EXPECT_NEAR(found->rate, 3.1, 0.03);
  EXPECT_NEAR(found->amplitude, 1.5, 0.2);
}

// It loses 30 % of its friction in 20 s: half of that from the middle of one half to that of the other.
TEST_F(ResidualLinesTest, FindFrictionThatFallsWhileTheArmWarmsUp) {
  const double viscous = bench.arm().viscous[kJoint], coulomb = bench.arm().coulomb[kJoint];
  const Eigen::MatrixXd left = residuals_of([&](double t, SimulatedSample& each) {
    const double qd = each.qd(kJoint);
    each.tau(kJoint) -= 0.3 * t / 20 * (viscous * qd + std::copysign(coulomb, qd));
  });
  const std::optional<FrictionChange> found = change_of(left, kJoint);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->share, -0.15, 0.04);
  EXPECT_NEAR(found->coulomb, -0.15 * coulomb, 0.5);
  EXPECT_FALSE(change_of(left, 0));
}

}  // namespace
}  // namespace flatdyn
