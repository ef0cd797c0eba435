// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/excitation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "laboratory/identify/excitation_log.hpp"
#include "laboratory/identify/excitation_objective.hpp"
#include "support/gradient.hpp"
#include "support/identified_arm.hpp"
#include "support/robot_models.hpp"

namespace flatdyn::testing {
namespace {

using ::testing::HasSubstr;

struct Excited {
  explicit Excited(const std::string& file) : torques(model_of(file), ParameterSet::given, progress) {}
  Progress progress{true};
  TorqueModel torques;
};

const TorqueModel& planar_arm() {
  static const Excited arm("planar_2r_example_7_2.toml");
  return arm.torques;
}

Excitation found(const TorqueModel& model, const ExcitationOptions& options) {
  Progress progress(true);
  return make_excitation(MotionEquations(model), options, progress);
}

ExcitationOptions short_search() {
  ExcitationOptions options;
  options.rate = 20;
  options.evaluations = 300;
  options.time = {};  // no limit, since sanitizers are slow
  return options;
}

TEST(Excitation, IsMuchBetterThanARandomMotion) {
  const Excitation excitation = found(planar_arm(), short_search());
  EXPECT_LT(excitation.motion.conditioning.relative, 3.5);
  EXPECT_LT(excitation.motion.conditioning.relative, 0.7 * excitation.start.conditioning.relative);
  EXPECT_FALSE(excitation.out_of_time);
}

// Checks the limits of the mechanism as in the file, not as the search sees them.
void expect_within_limits(const TorqueModel& model, const PlannedMotion& motion, double margin) {
  const std::vector<JointLimits> limits = motion_limits(model.mechanism());
  for (std::size_t k = 0; k < motion.samples.size(); ++k) {
    for (std::size_t i = 0; i < limits.size(); ++i) {
      ASSERT_LE(std::abs(motion.samples[k].q[i] - limits[i].middle()), margin * limits[i].reach()) << k;
      ASSERT_LE(std::abs(motion.samples[k].qd[i]), margin * limits[i].speed) << k;
      ASSERT_LE(std::abs(motion.samples[k].qdd[i]), margin * limits[i].acceleration) << k;
      ASSERT_LE(std::abs(motion.torques[k][i]), margin * limits[i].torque) << k;
    }
  }
}

TEST(Excitation, KeepsTheLimitsAndUsesThem) {
  const ExcitationOptions options = short_search();
  const Excitation excitation = found(planar_arm(), options);
  expect_within_limits(planar_arm(), excitation.start, options.margin);
  expect_within_limits(planar_arm(), excitation.motion, options.margin);
  for (const LimitUse& use : excitation.motion.use) {
    EXPECT_GT(std::max({use.position, use.speed, use.acceleration}), 0.5 * options.margin);
  }
}

// Gravity at q = 0 takes 1030 N m of the shoulder's limit; the motion that ignores torques exceeds the whole limit.
TEST(Excitation, KeepsTorqueLimits) {
  LoadedRobot model = model_of("planar_2r_example_7_2.toml");
  const ExcitationOptions options = short_search();
  const Excitation free = found(planar_arm(), options);
  double largest = 0;
  for (const std::vector<double>& tau : free.motion.torques) largest = std::max(largest, std::abs(tau[0]));
  constexpr int limit = 1200;
  ASSERT_GT(largest, options.margin * limit);
  model.mechanism.bodies[0].limits.effort = Value{Number(limit), {}};
  Progress progress(true);
  const TorqueModel limited(model, ParameterSet::given, progress);
  const Excitation excitation = found(limited, options);
  EXPECT_DOUBLE_EQ(motion_limits(limited.mechanism())[0].torque, limit);
  expect_within_limits(limited, excitation.motion, options.margin);
  EXPECT_LT(excitation.motion.conditioning.relative, 8);
}

double largest_use(const LimitUse& use) { return std::max({use.position, use.speed, use.acceleration}); }

// With columns of unit length the finger's first joint could stand still without a change of the criterion.
TEST(Excitation, LetsNoJointStandStill) {
  const Excited finger("finger.toml");
  const Excitation excitation = found(finger.torques, {.duration = 5, .evaluations = 600, .time = {}});
  for (const LimitUse& use : excitation.motion.use) EXPECT_GT(largest_use(use), 0.4);
  EXPECT_LT(excitation.motion.conditioning.unscaled, 0.2 * excitation.start.conditioning.unscaled);
}

// Gravity takes most of the elbow's limit; the base and the wrist hardly load it, and keep moving.
TEST(Excitation, MovesLessOnlyWhatLoadsATorqueLimit) {
  LoadedRobot model = model_of("ur5.urdf");
  constexpr int limit = 20;
  model.mechanism.bodies[2].limits.effort = Value{Number(limit), {}};
  Progress progress(true);
  const TorqueModel limited(model, ParameterSet::given, progress);
  const ExcitationOptions options{.rate = 20, .evaluations = 1000, .time = {}};
  const Excitation excitation = found(limited, options);
  expect_within_limits(limited, excitation.motion, options.margin);
  EXPECT_GT(excitation.motion.use[2].torque, 0.7 * options.margin);
  for (const std::size_t i : {0u, 3u, 4u, 5u}) EXPECT_GT(largest_use(excitation.motion.use[i]), 0.5) << i;
  // Shrunk from a motion that exceeds limits, the motion told less than a random one.
  EXPECT_LT(excitation.motion.cost, excitation.start.cost - 0.3);
}

TEST(Excitation, IsNotWorseThanTheStart) {
  ExcitationOptions options = short_search();
  for (const int evaluations : {1, 10, 30}) {
    options.evaluations = evaluations;
    const Excitation excitation = found(planar_arm(), options);
    EXPECT_LE(excitation.motion.cost, excitation.start.cost);
    EXPECT_LE(excitation.evaluations, evaluations);
  }
}

// With 50 samples of five harmonics, the maximum of a sine may lie between two.
TEST(Excitation, KeepsLimitsBetweenSamples) {
  ExcitationOptions options = short_search();
  options.duration = 5;
  options.rate = 10;
  const PlannedMotion motion = found(planar_arm(), options).motion;
  const std::vector<JointLimits> limits = motion_limits(planar_arm().mechanism());
  for (const FourierMotion& at : sampled(motion.trajectory, 5000)) {
    for (std::size_t i = 0; i < limits.size(); ++i) {
      ASSERT_LE(std::abs(at.q[i] - limits[i].middle()), 1.003 * options.margin * limits[i].reach());
      ASSERT_LE(std::abs(at.qd[i]), 1.003 * options.margin * limits[i].speed);
      ASSERT_LE(std::abs(at.qdd[i]), 1.003 * options.margin * limits[i].acceleration);
    }
  }
}

TEST(Excitation, RefusesARobotThatCannotHoldItself) {
  LoadedRobot model = model_of("planar_2r_example_7_2.toml");
  model.mechanism.bodies[0].limits.effort = Value{Number(10), {}};
  Progress progress(true);
  const TorqueModel weak(model, ParameterSet::given, progress);
  ExcitationOptions options = short_search();
  options.evaluations = 10;
  try {
    make_excitation(MotionEquations(weak), options, progress);
    FAIL();
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.kind(), FailureKind::unsupported);
    EXPECT_THAT(failure.what(), HasSubstr("joint \"theta_1\": gravity or friction alone takes 1030 N m"));
    EXPECT_THAT(failure.what(), HasSubstr("9 may be used"));
  }
}

TEST(Excitation, IsTheSameInEveryRunOfASeed) {
  ExcitationOptions options = short_search();
  options.evaluations = 60;
  const auto positions = [&] { return found(planar_arm(), options).motion.samples[77].q; };
  const std::vector<double> first = positions();
  EXPECT_EQ(positions(), first);
  options.seed = 2;
  EXPECT_NE(positions(), first);
}

TEST(Excitation, TorquesAreThoseOfTheFile) {
  ExcitationOptions options = short_search();
  options.evaluations = 10;
  const PlannedMotion motion = found(planar_arm(), options).motion;
  // At rest at q = 0, stretched out: g_1 = (50 0.5 + 5 + 50 + 50 0.5 ...) 9.81 and g_2 = 50 0.5 9.81 (Example 7.2).
  EXPECT_NEAR(motion.torques.front()[1], 50 * 0.5 * 9.81, 1e-9);
  EXPECT_NEAR(motion.torques.front()[0], (50 * 0.5 + (50 + 5) * 1 + 50 * 0.5) * 9.81, 1e-9);
}

TEST(ExcitationObjective, GradientIsTheDerivative) {
  std::vector<JointLimits> limits = within_margin(motion_limits(planar_arm().mechanism()), 0.9);
  limits[0].torque = 900;  // exceeded by the random motion, so that the penalty has a slope, too
  const MotionEquations equations(planar_arm());
  ExcitationObjective objective(equations, limits, 10, 3);
  std::mt19937 engine(5);
  std::vector<double> x(static_cast<std::size_t>(objective.size()));
  for (double& value : x) value = 0.6 * (static_cast<double>(engine() % 1000) / 500 - 1);
  objective.scale_by({std::vector<double>(x.size(), 0.5), x});
  const double with_torque = objective(x.data(), nullptr);
  limits[0].torque = 1e9;
  ExcitationObjective without_torque(equations, limits, 10, 3);
  without_torque.scale_by({std::vector<double>(x.size(), 0.5), x});
  EXPECT_GT(with_torque, without_torque(x.data(), nullptr) + 1e-3);
  expect_gradient(objective, x);
}

// The standard deviations of the parameters after the motion and what is logged already, in rows of the motion's rate.
Eigen::VectorXd deviations_with(const TorqueModel& model, const PlannedMotion& motion, const Eigen::MatrixXd& logged) {
  const int n = model.joints(), b = model.parameters();
  Eigen::MatrixXd all(static_cast<Eigen::Index>(motion.samples.size()) * n + logged.rows(), b);
  all.bottomRows(logged.rows()) = logged;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> y(n, b);
  for (std::size_t k = 0; k < motion.samples.size(); ++k) {
    const FourierMotion& at = motion.samples[k];
    model.regressor(at.q.data(), at.qd.data(), at.qdd.data(), y.data());
    all.middleRows(static_cast<Eigen::Index>(k) * n, n) = y;
  }
  return (all.transpose() * all).inverse().diagonal().cwiseSqrt();
}

// In the log only the first joint moves, for long. A motion that knows of it leaves smaller standard deviations than
// one that does not: on average, and of the parameters that the log tells little of.
TEST(Excitation, CompletesALog) {
  const Arm arm("finger.toml");
  ExcitationOptions options = short_search();
  options.duration = 5;
  const SimulationOptions logged{.samples = 6000, .rate = 100, .moving = false};
  const LoggedInformation log = information_of(arm.observed(simulated(arm.robot, logged)), 1 / logged.rate);
  EXPECT_NEAR(log.seconds, 60, 1e-9);
  const Excitation plain = found(arm.torque, options);
  options.logged = log.root;
  const Excitation refined = found(arm.torque, options);
  const Eigen::MatrixXd rows = std::sqrt(options.rate) * log.root;
  const Eigen::VectorXd before = deviations_with(arm.torque, plain.motion, rows);
  const Eigen::VectorXd after = deviations_with(arm.torque, refined.motion, rows);
  EXPECT_TRUE(after.isApprox(refined.motion.conditioning.standard_deviations, 1e-6));
  const Eigen::VectorXd alone = deviations_with(arm.torque, plain.motion, Eigen::MatrixXd(0, before.size()));
  double all = 0, open = 0;  // logarithms of the refined motion's standard deviations, relative to the plain one's
  int of_all = 0, of_open = 0;
  for (Eigen::Index k = 0; k < before.size(); ++k) {
    const double change = std::log(after(k) / before(k));
    all += change;
    ++of_all;
    if (before(k) < 0.8 * alone(k)) continue;  // the log tells of it
    open += change;
    ++of_open;
  }
  EXPECT_LT(all / of_all, std::log(0.9));
  EXPECT_GE(of_open, 5);
  EXPECT_LT(open / of_open, std::log(0.96));
}

TEST(MotionLimits, AreTheFilesOrTheDocumentedDefaults) {
  const std::vector<JointLimits> panda = motion_limits(model_of("panda.urdf").mechanism);
  EXPECT_DOUBLE_EQ(panda[3].lower, -3.0718);
  EXPECT_DOUBLE_EQ(panda[3].upper, -0.0698);
  EXPECT_DOUBLE_EQ(panda[0].torque, 87);
  EXPECT_DOUBLE_EQ(panda[0].acceleration, 15);
  EXPECT_DOUBLE_EQ(motion_limits(planar_arm().mechanism())[0].acceleration, 10);
  const std::vector<JointLimits> sliding = motion_limits(model_of("cartesian_2.toml").mechanism);
  EXPECT_DOUBLE_EQ(sliding[0].reach(), 0.25);
  EXPECT_DOUBLE_EQ(sliding[0].speed, 0.5);
  EXPECT_DOUBLE_EQ(sliding[0].acceleration, 2);
  EXPECT_TRUE(std::isinf(sliding[0].torque));
}

}  // namespace
}  // namespace flatdyn::testing
