// SPDX-License-Identifier: GPL-2.0-or-later
// Base parameters from simulated motion with known truth.
#include "laboratory/identify/least_squares.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "support/identified_arm.hpp"

namespace flatdyn {
namespace {

using Eigen::VectorXd;
using testing::Arm;
using testing::simulated;

TEST(LeastSquares, RecoversEveryBaseParameterFromNoiseFreeMotion) {
  for (const char* robot : {"planar_2r_example_7_2.toml", "puma560.toml"}) testing::expect_recovery(robot);
}

TEST(LeastSquares, JointByJointFindsTheSameWithoutNoise) {
  const Arm arm("puma560.toml");
  const Observations observations = arm.observed(simulated(arm.robot, {.samples = 600}));
  const VectorXd found = estimate_joint_by_joint(observations, VectorXd::Zero(observations.parameters));
  EXPECT_LT((found - arm.truth()).norm(), 1e-9 * arm.truth().norm());
}

// 95 % intervals contain the truth 95 % of the time, over 400 noisy runs and all parameters.
TEST(LeastSquares, IntervalsAreHonest) {
  constexpr int kRuns = 400;
  constexpr double kTwoSided95 = 1.959964;
  const Arm arm("planar_2r_example_7_2.toml", ParameterSet::full);
  const VectorXd truth = arm.truth();
  int inside = 0;
  for (int run = 0; run < kRuns; ++run) {
    const auto samples =
        simulated(arm.robot, {.samples = 200, .rate = 20, .noise = 3, .seed = static_cast<unsigned>(run + 1)});
    const Estimate found = estimate(arm.observed(samples), VectorXd::Zero(truth.size()));
    const VectorXd error = (found.values - truth).cwiseAbs();
    inside += static_cast<int>((error.array() <= kTwoSided95 * found.standard_deviations.array()).count());
  }
  const double part = static_cast<double>(inside) / static_cast<double>(kRuns * truth.size());
  EXPECT_GE(part, 0.93);
  EXPECT_LE(part, 0.97);
}

// The second joint is ten times noisier, so its rows have a hundredth of the weight.
TEST(LeastSquares, WeightsFollowTheNoiseOfEachJoint) {
  const Arm arm("planar_2r_example_7_2.toml");
  auto samples = simulated(arm.robot, {.samples = 2000});
  testing::Uniform draw(5);
  for (testing::SimulatedSample& sample : samples) {
    sample.tau(0) += 0.5 * draw.normal();
    sample.tau(1) += 5 * draw.normal();
  }
  const Estimate found = estimate(arm.observed(samples), arm.truth());
  EXPECT_TRUE(found.converged);
  EXPECT_NEAR(found.torque_deviations(0), 0.5, 0.05);
  EXPECT_NEAR(found.torque_deviations(1), 5, 0.5);
}

// Only the first joint moves: parameters that this does not tell stay at their prior values.
TEST(LeastSquares, WhatTheMotionDoesNotTellStaysAtThePrior) {
  const Arm arm("puma560.toml");
  const Observations observations = arm.observed(simulated(arm.robot, {.samples = 500, .moving = false}));
  const VectorXd prior = arm.truth() + VectorXd::Constant(arm.truth().size(), 0.1);
  const Estimate found = estimate(observations, prior);
  EXPECT_FALSE(found.damped.empty());
  EXPECT_TRUE(found.values.allFinite());
  // A parameter with a part in a damped direction is not known at all; others are.
  EXPECT_TRUE(std::isinf(found.standard_deviations.maxCoeff()));
  EXPECT_TRUE(std::isfinite(found.standard_deviations.minCoeff()));
  for (Eigen::Index k = 0; k < prior.size(); ++k) {
    if (std::isinf(found.standard_deviations(k))) continue;
    EXPECT_NEAR(found.values(k), arm.truth()(k), 1e-6) << k;
  }
  EXPECT_LT((found.values - prior).norm(), 2 * (arm.truth() - prior).norm());
  for (std::size_t i = 0; i < observations.joints.size(); ++i) {
    EXPECT_LT(observations.joints[i].rms_residual(found.values), 1e-6) << i;
  }
}

// Encoders of joints that are held always have some noise, so no singular value is zero: the noise of the torques hides
// the columns of these joints.
TEST(LeastSquares, WhatNoiseHidesStaysNearThePrior) {
  const Arm arm("ur5.urdf");
  auto samples = simulated(arm.robot, {.samples = 2000, .noise = 1, .moving = false});
  testing::Uniform draw(5);
  for (testing::SimulatedSample& sample : samples) {
    for (VectorXd* each : {&sample.q, &sample.qd, &sample.qdd}) {
      for (double& number : *each) number += 1e-5 * draw.normal();
    }
  }
  const VectorXd prior = 1.5 * arm.truth();
  const double largest = prior.cwiseAbs().maxCoeff();
  const Estimate found = estimate(arm.observed(samples), prior);
  EXPECT_TRUE(found.damped.empty());
  ASSERT_FALSE(found.hidden.empty());
  EXPECT_LT((found.values - arm.truth()).cwiseAbs().maxCoeff(), 10 * largest);
  const Estimate without_sizes = estimate(arm.observed(samples), VectorXd::Zero(prior.size()));
  EXPECT_GT(without_sizes.values.cwiseAbs().maxCoeff(), 100 * largest);
  for (Eigen::Index k = 0; k < prior.size(); ++k) {
    if (std::isinf(found.standard_deviations(k))) continue;
    EXPECT_NEAR(found.values(k), arm.truth()(k), 6 * found.standard_deviations(k)) << k;
  }
  for (const JointObservations& joint : arm.observed(samples).joints) {
    EXPECT_NEAR(joint.rms_residual(found.values), 1, 0.1);
  }
}

// If the sizes in a file are far too small, the information of the motion is still not taken for noise.
TEST(LeastSquares, WhatTheMotionTellsDoesNotStayAtAFileOfOtherSizes) {
  const Arm arm("planar_2r_example_7_2.toml");
  const Observations observations = arm.observed(simulated(arm.robot, {.samples = 400, .noise = 50}));
  const VectorXd prior = 1e-6 * arm.truth();
  const Estimate small = estimate(observations, prior), right = estimate(observations, arm.truth());
  for (Eigen::Index k = 0; k < prior.size(); ++k) {
    const double deviation = right.standard_deviations(k);
    if (std::abs(arm.truth()(k)) < 20 * deviation) continue;
    EXPECT_NEAR(small.values(k), right.values(k), deviation) << k;
  }
}

TEST(LeastSquares, JointByJointWhatTheMotionDoesNotTellStaysAtThePrior) {
  const Arm arm("puma560.toml");
  const Observations observations = arm.observed(simulated(arm.robot, {.samples = 500, .moving = false}));
  const VectorXd found = estimate_joint_by_joint(observations, arm.truth());
  EXPECT_LT((found - arm.truth()).norm(), 1e-6 * arm.truth().norm());
}

TEST(LeastSquares, OfARobotThatStandsStillNothingBlowsUp) {
  const Arm arm("ur5.urdf");
  auto samples = simulated(arm.robot, {.samples = 50});
  for (testing::SimulatedSample& sample : samples) {
    sample.qd.setZero();
    sample.qdd.setZero();
    sample.tau.setZero();
  }
  const Estimate found = estimate(arm.observed(samples), arm.truth());
  EXPECT_TRUE(found.values.allFinite());
  EXPECT_TRUE((found.standard_deviations.array() >= 0).all());
}

TEST(LeastSquares, FewerEquationsThanParametersAreRefused) {
  const Arm arm("puma560.toml");
  EXPECT_THROW(estimate(arm.observed(simulated(arm.robot, {.samples = 3})), arm.truth()), Failure);
}

// The information on some parameters with the others unknown is the inverse of their block of the covariance.
TEST(LeastSquares, InformationOfTheFirstIsThatOfTheirCovariance) {
  const Arm arm("planar_2r_example_7_2.toml");
  const Estimate found = estimate(arm.observed(simulated(arm.robot, {.samples = 200, .noise = 1})), arm.truth());
  ASSERT_TRUE(found.damped.empty());
  const Eigen::MatrixXd information = found.root_information.transpose() * found.root_information;
  const Eigen::MatrixXd first = Eigen::MatrixXd(information.inverse()).topLeftCorner(3, 3).inverse();
  const Eigen::MatrixXd root = root_information_of_first(found, 3);
  EXPECT_LT((root.transpose() * root - first).norm(), 1e-9 * first.norm());
  for (Eigen::Index k = 0; k < 3; ++k) {
    EXPECT_NEAR(std::sqrt(information.inverse()(k, k)), found.standard_deviations(k),
                1e-6 * found.standard_deviations(k));
  }
}

}  // namespace
}  // namespace flatdyn
