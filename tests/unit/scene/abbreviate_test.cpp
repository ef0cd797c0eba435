// SPDX-License-Identifier: GPL-2.0-or-later
// What is given up stays below the bound, and the bound below the budget.
#include "scene/abbreviate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "graph/arithmetic.hpp"
#include "graph/count.hpp"
#include "passes/passes.hpp"
#include "support/robot_models.hpp"
#include "support/robots.hpp"
#include "symbolic/functions.hpp"
#include "verify/exact.hpp"

namespace flatdyn {
namespace {

// Within the limits; at their corners in every other state.
class StatesWithinLimits {
 public:
  explicit StatesWithinLimits(const Mechanism& mechanism) : mechanism_(mechanism) {}

  std::vector<double> torques(const Function& function, unsigned state) const {
    std::mt19937_64 engine(state);
    std::uniform_real_distribution<double> uniform(-1, 1);
    std::vector<double> drawn(3 * mechanism_.bodies.size());
    for (double& x : drawn) x = state % 2 == 0 ? uniform(engine) : std::copysign(1.0, uniform(engine));
    for (std::size_t i = 0; i < mechanism_.bodies.size(); ++i) drawn[i] = uniform(engine);
    RealArithmetic<double> arithmetic([&](const Input& input) { return value(input, drawn); });
    const std::vector<double> values = evaluate(function, arithmetic);
    std::vector<double> tau;
    for (const NodeId root : roots(function)) tau.push_back(values[static_cast<std::size_t>(root)]);
    return tau;
  }

 private:
  double value(const Input& input, const std::vector<double>& drawn) const {
    const std::size_t n = mechanism_.bodies.size(), i = static_cast<std::size_t>(input.index);
    const Limits& limits = mechanism_.bodies[i].limits;
    if (input.kind == InputKind::qd) return drawn[n + i] * nearest_double(limits.velocity->number);
    if (input.kind == InputKind::qdd) return drawn[2 * n + i] * nearest_double(limits.acceleration->number);
    const double range = mechanism_.bodies[i].prismatic ? nearest_double(limits.upper->number) : 3.2;
    return drawn[i] * range;
  }

  const Mechanism& mechanism_;
};

// Every joint moves at up to 2 /s and 10 /s^2, and takes 100 N m (N).
Mechanism with_limits(Mechanism mechanism) {
  for (Body& body : mechanism.bodies) {
    body.limits.velocity = Value{2, {}};
    body.limits.acceleration = Value{10, {}};
    body.limits.effort = Value{100, {}};
    body.limits.upper = Value{Number(1) / 2, {}};
    body.limits.lower = Value{Number(-1) / 2, {}};
  }
  return mechanism;
}

void expect_within_bounds(const Mechanism& mechanism, const std::string& budget) {
  const Abbreviation short_model = abbreviated(mechanism, *error_budget(budget));
  const Function full = derive_function(mechanism, "inverse_dynamics");
  const Function small = derive_function(short_model.mechanism, "inverse_dynamics");
  const StatesWithinLimits states(mechanism);
  for (unsigned state = 0; state < 200; ++state) {
    const std::vector<double> tau = states.torques(full, state), other = states.torques(small, state);
    for (std::size_t i = 0; i < tau.size(); ++i) {
      EXPECT_LE(std::abs(tau[i] - other[i]), short_model.bound[i] + 1e-9 * std::abs(tau[i])) << "joint " << i;
    }
  }
  for (std::size_t i = 0; i < short_model.bound.size(); ++i) EXPECT_LE(short_model.bound[i], short_model.budget[i]);
}

class RandomBudgets : public ::testing::TestWithParam<unsigned> {};

TEST_P(RandomBudgets, BoundWhatIsGivenUp) {
  const Mechanism mechanism = with_limits(make_mechanism(testing::random_tree(GetParam(), 5)));
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

TEST(ErrorBudget, OfNothingGivesNothingUp) {
  const Mechanism panda = testing::model_of("panda.urdf").mechanism;
  const Abbreviation result = abbreviated(panda, *error_budget("0"));
  EXPECT_TRUE(result.dropped.empty());
}

TEST(ErrorBudget, KeepsBPositiveDefinite) {
  const Mechanism ur5 = with_limits(testing::model_of("ur5.urdf").mechanism);
  for (const char* budget : {"10%", "30%", "100%"}) {
    const Abbreviation result = abbreviated(ur5, *error_budget(budget));
    EXPECT_FALSE(result.dropped.empty());
    Function forward = derive_function(result.mechanism, "forward_dynamics");
    forward.outputs.clear();  // its conditions only
    const StatesWithinLimits states(ur5);
    for (unsigned state = 0; state < 300; ++state) {
      for (const double pivot : states.torques(forward, state)) EXPECT_GT(pivot, 0) << budget;
    }
  }
}

TEST(ErrorBudget, LeavesThePotentialEnergyWhereItWas) {
  for (const char* robot : {"panda.urdf", "puma560.toml", "quadruped12.urdf"}) {
    const Mechanism whole = with_limits(testing::model_of(robot).mechanism);
    const Mechanism part = abbreviated(whole, *error_budget("0")).mechanism;
    const Function before = derive_function(whole, "potential_energy"),
                   after = derive_function(part, "potential_energy");
    EXPECT_TRUE(prove_equal(before, after).equal) << robot;
  }
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
