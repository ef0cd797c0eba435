// SPDX-License-Identifier: GPL-2.0-or-later
// The error of an abbreviated function stays below its bound, and the bound below the budget.
#include "functions/scene/abbreviate.hpp"

#include <gtest/gtest.h>

#include "functions/exact_proof.hpp"
#include "functions/planning/formulations.hpp"
#include "graph/count.hpp"
#include "graph/passes/passes.hpp"
#include "proof/verify/torque_deviation.hpp"
#include "robot/model/states.hpp"
#include "support/floating_robots.hpp"
#include "support/limited_robots.hpp"
#include "support/robot_models.hpp"
#include "support/robots.hpp"
#include "support/written_model.hpp"
#include "truth/reference/graph_evaluator.hpp"

namespace flatdyn {
namespace {

void expect_within_bounds(const Mechanism& mechanism, const std::string& budget) {
  const Abbreviation part = abbreviated(mechanism, *error_budget(budget));
  EXPECT_TRUE(torque_deviation(mechanism, part.mechanism, false, 200).is_within(part)) << budget;
  for (std::size_t i = 0; i < part.bound.size(); ++i) EXPECT_LE(part.bound[i], part.budget[i]) << "joint " << i;
}

class RandomBudgets : public ::testing::TestWithParam<unsigned> {};

TEST_P(RandomBudgets, BoundWhatIsGivenUp) {
  const Mechanism mechanism = testing::within_limits(make_mechanism(testing::random_tree(GetParam(), 5)));
  for (const char* budget : {"1%", "30%", "5", "100%"}) expect_within_bounds(mechanism, budget);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomBudgets, ::testing::Range(1u, 9u));

int operations(const Mechanism& mechanism) {
  return count_operations(run_passes(derive_function(mechanism, "inverse_dynamics"))).arithmetic();
}

TEST(ErrorBudget, IsAPercentageOrATorque) {
  EXPECT_EQ(error_budget("0.1%")->value, 0.001);
  EXPECT_TRUE(error_budget("0.1%")->relative);
  EXPECT_EQ(error_budget("0.05")->value, 0.05);
  EXPECT_FALSE(error_budget("0.05")->relative);
  for (const char* wrong : {"", "%", "a lot", "-1", "101%", "nan", "1 %x"}) EXPECT_FALSE(error_budget(wrong)) << wrong;
}

TEST(ErrorBudget, NeedsLimitsAndNumbers) {
  const Mechanism bare = make_mechanism(testing::random_tree(1, 3, true));
  EXPECT_THROW(abbreviated(bare, *error_budget("1%")), Failure);
  const Mechanism symbolic = testing::model_of("planar_2r.toml").mechanism;
  EXPECT_THROW(abbreviated(symbolic, *error_budget("1%")), Failure);
}

// The base's force and moment have budgets, too.
TEST(ErrorBudget, OfAFloatingBase) {
  const Mechanism satellite = testing::within_limits(testing::model_of_toml(testing::kSatellite).mechanism);
  for (const char* budget : {"1%", "10%", "3"}) expect_within_bounds(satellite, budget);
  const Abbreviation part = abbreviated(satellite, *error_budget("10%"));
  EXPECT_EQ(part.bound.size(), 9u);
  EXPECT_GT(part.dropped.size(), 1u);
  EXPECT_LT(operations(part.mechanism), operations(satellite));
  EXPECT_TRUE(prove_exactly(part.mechanism, derive_function(part.mechanism, "inverse_dynamics")).equal);
  Mechanism without = satellite;
  without.bodies[3].limits.velocity.reset();
  EXPECT_THROW(abbreviated(without, *error_budget("10%")), Failure);
}

// The components of a spherical joint's moment have budgets, on a fixed and on a floating base.
TEST(ErrorBudget, OfSphericalJoints) {
  for (const char* file : {"ball_wrist.toml", "free_arm.toml"}) {
    const std::filesystem::path path = std::filesystem::path(FLATDYN_SOURCE_DIR) / "docs/examples" / file;
    const Mechanism mechanism = testing::within_limits(load_robot(path, {}).mechanism);
    for (const char* budget : {"1%", "10%", "30%", "100%"}) expect_within_bounds(mechanism, budget);
    const Abbreviation part = abbreviated(mechanism, *error_budget("30%"));
    EXPECT_GT(part.dropped.size(), 1u) << file;
    EXPECT_LT(operations(part.mechanism), operations(mechanism)) << file;
    EXPECT_TRUE(prove_exactly(part.mechanism, derive_function(part.mechanism, "inverse_dynamics")).equal) << file;
  }
}

TEST(ErrorBudget, OfNothingGivesNothingUp) {
  const Mechanism panda = testing::model_of("panda.urdf").mechanism;
  const Abbreviation result = abbreviated(panda, *error_budget("0"));
  EXPECT_TRUE(result.dropped.empty());
  EXPECT_EQ(operations(result.mechanism), operations(panda));
}

TEST(ErrorBudget, KeepsBPositiveDefinite) {
  const Mechanism ur5 = testing::within_limits(testing::model_of("ur5.urdf").mechanism);
  for (const char* budget : {"10%", "30%", "100%"}) {
    const Abbreviation result = abbreviated(ur5, *error_budget(budget));
    EXPECT_FALSE(result.dropped.empty());
    const Function forward = derive_function(result.mechanism, "forward_dynamics");
    GraphEvaluator<double> acceleration(forward);
    // The seed differs from that of the check in the program.
    for (const State& state : random_states(ur5, 300, 7)) EXPECT_TRUE(acceleration(state)) << budget;
  }
}

TEST(ErrorBudget, IsNotSpentOnMomentsOfInertiaForGravity) {
  const Mechanism panda = testing::model_of("panda.urdf").mechanism;
  const Abbreviation result = abbreviated(panda, *error_budget("1%"), {.only_gravity = true});
  EXPECT_FALSE(result.dropped.empty());
  for (const DroppedParameter& each : result.dropped) EXPECT_EQ(each.name.front(), 'm') << each.name;
}

TEST(ErrorBudget, BuysOperations) {
  const Mechanism panda = testing::model_of("panda.urdf").mechanism;
  expect_within_bounds(panda, "1%");
  int before = operations(panda);
  for (const char* budget : {"0.1%", "1%", "5%"}) {
    const Abbreviation result = abbreviated(panda, *error_budget(budget));
    const int now = operations(result.mechanism);
    EXPECT_LT(now, before) << budget;
    before = now;
  }
}

}  // namespace
}  // namespace flatdyn
