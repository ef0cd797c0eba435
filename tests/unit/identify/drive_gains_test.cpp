// SPDX-License-Identifier: GPL-2.0-or-later
// The gains of drives, from logs of currents with a payload of known mass and without it.
#include "laboratory/identify/drive_gains.hpp"

#include <gtest/gtest.h>

#include "support/practical_bench.hpp"

namespace flatdyn {
namespace {

using testing::practical_ur5;
using testing::SimulatedSample;
using testing::ur5;

constexpr double kMass = 4;  // kg

LoadedRobot with_a_ball() {
  LoadedRobot robot = practical_ur5().truth();
  Inertial ball;
  ball.mass.number = GiNaC::numeric(static_cast<long>(kMass));
  ball.centre_of_mass = {GiNaC::numeric(1, 50), 0, GiNaC::numeric(1, 10)};
  for (std::size_t k = 0; k < 3; ++k) ball.tensor[k][k] = GiNaC::numeric(1, 50);
  robot.robot.links[static_cast<std::size_t>(robot.robot.tip)].inertials.push_back(ball);
  robot.mechanism = make_mechanism(robot.robot);
  return robot;
}

class DriveGainsTest : public ::testing::Test {
 protected:
  // The currents of drives with these gains, in A.
  Measurement measured(std::vector<SimulatedSample> samples, double noise, unsigned seed) {
    for (SimulatedSample& sample : samples) {
      for (Eigen::Index i = 0; i < sample.tau.size(); ++i) {
        sample.tau(i) += noise * bench_.arm().noise[static_cast<std::size_t>(i)] * draw_.normal();
        sample.tau(i) /= gains_(i);
      }
    }
    return bench_.measured(samples, noise > 0 ? testing::kEncoderStep : 0, 0, seed);
  }

  DriveGains found(double noise, unsigned motion) {
    const std::vector<SimulatedSample> with =
                                           practical_motion(bench_.arm(), loaded_, {.seconds = 12, .motion = motion}),
                                       without = bench_.motion({.seconds = 12, .motion = motion + 100});
    return drive_gains(bench_.model(), {measured(with, noise, motion), measured(without, noise, motion + 100)}, kMass);
  }

  testing::PracticalBench& bench_ = ur5();
  LoadedRobot loaded_ = with_a_ball();
  testing::Uniform draw_{7};
  // N m/A; the current of the second joint counts backwards
  Eigen::VectorXd gains_{{13.2, -11.5, 10.1, 7.6, 8.2, 8.9}};
};

TEST_F(DriveGainsTest, ComeBackWithoutNoise) {
  const DriveGains gains = found(0, 1);
  EXPECT_TRUE(gains.converged);
  EXPECT_LT((gains.factors - gains_).cwiseQuotient(gains_).cwiseAbs().maxCoeff(), 1e-3);
  EXPECT_NEAR(gains.fit.payload.values(3) / kMass, 0.1, 1e-3);  // the centre of mass
}

// Three motions of six gains: one interval of 18 at 95 % may miss by chance, and even three hardly ever do.
TEST_F(DriveGainsTest, LieInTheirIntervals) {
  int inside = 0;
  for (unsigned motion = 1; motion <= 3; ++motion) {
    const DriveGains gains = found(1, motion);
    EXPECT_TRUE(gains.converged) << motion;
    for (Eigen::Index i = 0; i < gains_.size(); ++i) {
      const double error = std::abs(gains.factors(i) - gains_(i));
      EXPECT_LT(gains.standard_deviations(i), 0.1 * std::abs(gains_(i))) << motion << ", " << i;
      inside += error < 1.96 * gains.standard_deviations(i) ? 1 : 0;
    }
  }
  EXPECT_GE(inside, 15);
}

}  // namespace
}  // namespace flatdyn
