// SPDX-License-Identifier: GPL-2.0-or-later
// The contributions add up to the recursive reference's torques, for arms, trees, motors and friction.
#include "laboratory/trajectory/torque_terms.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "flatdyn/reference/newton_euler.hpp"
#include "support/sprung_puma.hpp"
#include "truth/reference/reference_model.hpp"

namespace flatdyn {
namespace {

using testing::model_of;

TrajectoryPoint random_point(int joints, bool tip_force, std::mt19937& engine) {
  std::uniform_real_distribution<double> uniform(-2, 2);
  TrajectoryPoint point;
  for (std::vector<double>* part : {&point.q, &point.qd, &point.qdd}) {
    for (int i = 0; i < joints; ++i) part->push_back(uniform(engine));
  }
  for (int k = 0; tip_force && k < 6; ++k) point.h_e.push_back(30 * uniform(engine));
  return point;
}

reference::VectorX<double> reference_torques(const Robot& robot, const TrajectoryPoint& point) {
  reference::Environment<double> environment;
  if (!point.h_e.empty()) {
    environment.f_e = Eigen::Vector3d(point.h_e.data());
    environment.mu_e = Eigen::Vector3d(point.h_e.data() + 3);
  }
  return reference::inverse_dynamics(reference_robot<double>(robot, {}), vector_of(point.q), vector_of(point.qd),
                                     vector_of(point.qdd), environment);
}

void expect_the_references_sum(const LoadedRobot& model) {
  Progress quiet(true);
  for (const bool tip_force : {false, true}) {
    TorqueTerms terms(model, tip_force, quiet);
    const auto n = static_cast<std::size_t>(terms.joints());
    std::mt19937 engine(7);
    std::vector<double> values(terms.terms().size()), tau(n);
    for (int trial = 0; trial < 20; ++trial) {
      const TrajectoryPoint point = random_point(terms.joints(), tip_force, engine);
      terms.evaluate(point, values, tau);
      const reference::VectorX<double> expected = reference_torques(model.robot, point);
      std::vector<double> sums(n, 0), sizes(n, 0);
      for (std::size_t k = 0; k < values.size(); ++k) {
        const auto i = static_cast<std::size_t>(terms.terms()[k].joint);
        sums[i] += values[k];
        sizes[i] += std::abs(values[k]);
      }
      for (std::size_t i = 0; i < n; ++i) {
        EXPECT_NEAR(sums[i], expected[static_cast<Eigen::Index>(i)], 1e-13 * sizes[i] + 1e-13) << i;
        EXPECT_NEAR(tau[i], expected[static_cast<Eigen::Index>(i)], 1e-13 * sizes[i] + 1e-13) << i;
      }
    }
  }
}

class TermsOf : public ::testing::TestWithParam<const char*> {};

TEST_P(TermsOf, AddUpToTheReference) { expect_the_references_sum(model_of(GetParam())); }

TEST(TorqueTerms, HaveSprings) {
  const LoadedRobot model = testing::sprung_puma();
  expect_the_references_sum(model);
  Progress quiet(true);
  const std::vector<TorqueTerm> terms = TorqueTerms(model, false, quiet).terms();
  EXPECT_TRUE(
      std::any_of(terms.begin(), terms.end(), [](const TorqueTerm& term) { return term.name() == "spring_2"; }));
}

INSTANTIATE_TEST_SUITE_P(Robots, TermsOf,
                         ::testing::Values("planar_2r_example_7_2.toml", "puma560.toml", "ur5.urdf",
                                           "quadruped12.urdf"),
                         [](const auto& test) {
                           const std::string name = test.param;
                           return name.substr(0, name.find('.'));
                         });

// (7.82): b_12 depends on the second angle alone, a joint's own speed causes no centrifugal torque at it, and the
// second joint has no Coriolis torque: such terms do not exist.
TEST(TorqueTerms, LeaveOutWhatIsAlwaysZero) {
  Progress quiet(true);
  const TorqueTerms terms(model_of("planar_2r_example_7_2.toml"), false, quiet);
  std::vector<std::string> names;
  for (const TorqueTerm& term : terms.terms()) names.push_back(term.name());
  EXPECT_THAT(names, ::testing::ElementsAre("inertia_1_1", "inertia_1_2", "centrifugal_1_2", "coriolis_1_1_2",
                                            "gravity_1", "inertia_2_1", "inertia_2_2", "centrifugal_2_1", "gravity_2"));
}

// A scene that wants one entry at rest does not remove terms.
TEST(TorqueTerms, AreThoseOfTheWholeRobotWhateverTheSceneAsksFor) {
  LoadedRobot model = model_of("planar_2r_example_7_2.toml");
  model.robot.scene.at_rest = true;
  model.robot.scene.functions = {{"gravity", {}}};
  Progress quiet(true);
  EXPECT_EQ(TorqueTerms(model, false, quiet).terms().size(), 9u);
}

TEST(TorqueTerms, NeedNumbers) {
  Progress quiet(true);
  try {
    const TorqueTerms terms(model_of("planar_2r.toml"), false, quiet);
    ADD_FAILURE();
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.kind(), FailureKind::unsupported);
  }
}

// The sum is compared with the torques, which are derived independently.
TEST(TorqueTerms, DisagreementOfAHistoryIsRounding) {
  Progress quiet(true);
  TorqueTerms terms(model_of("puma560.toml"), false, quiet);
  std::mt19937 engine(3);
  Trajectory trajectory;
  for (int k = 0; k < 50; ++k) trajectory.points.push_back(random_point(terms.joints(), false, engine));
  const TorqueHistory history = torque_history(terms, trajectory);
  EXPECT_GT(history.disagreement, 0);
  EXPECT_LT(history.disagreement, 1e-14);
}

}  // namespace
}  // namespace flatdyn
