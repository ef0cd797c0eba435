// SPDX-License-Identifier: GPL-2.0-or-later
// B singular to the last place: a link of almost no mass between two joints about the same axis. A pivot is then only
// rounding error, and functions that divide by it report that.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "functions/planning/make_functions.hpp"
#include "proof/verify/compiled.hpp"
#include "proof/verify/verify.hpp"
#include "robot/model/states.hpp"
#include "support/printed_code.hpp"
#include "support/robot_models.hpp"
#include "support/written_model.hpp"
#include "truth/definition/pivot_ratio.hpp"
#include "truth/reference/graph_evaluator.hpp"

namespace flatdyn {
namespace {

LoadedRobot arm_with_link_of_mass(const std::string& mass) {
  return testing::model_of_toml(fmt::format(R"(
[[link]]
mass = 2
inertia_about = "com"
com = [0.3, 0, 0.1]
inertia = {{ xx = 0.1, yy = 0.2, zz = 0.2 }}
[[link]]
xyz = [0.5, 0, 0]
rpy = [1, 0, 0]
mass = {0}
inertia_about = "com"
com = [0.1, 0, 0]
inertia = {{ xx = {0}, yy = {0}, zz = {0} }}
[[link]]
mass = 1
inertia_about = "com"
com = [0.4, 0.1, 0.2]
inertia = {{ xx = 0.02, yy = 0.03, zz = 0.04 }}
)",
                                            mass));
}

const std::vector<std::string> kThatDivide = {"forward_dynamics", "forward_dynamics_derivatives",
                                              "operational_inertia"};

std::vector<OptimisedFunction> that_divide_by_pivots(const LoadedRobot& model) {
  PipelineOptions options;
  options.functions = kThatDivide;
  Progress quiet(true);
  Diagnostics none;
  return make_functions(model, options, quiet, none);
}

TEST(LostPivots, AreASmallShareOfTheDiagonal) {
  EXPECT_GT(smallest_pivot_ratio(arm_with_link_of_mass("1").mechanism), 1e-3);
  const double share = smallest_pivot_ratio(arm_with_link_of_mass("1e-9").mechanism);
  EXPECT_LT(share, 1e-7);
  EXPECT_GT(share, 1e-11);
  EXPECT_LT(smallest_pivot_ratio(arm_with_link_of_mass("1e-30").mechanism), 1e-15);
}

TEST(LostPivots, AreCheckedUnlessItIsProvenThatNoneIsLost) {
  // The pivots of J B^-1 J^T are always checked.
  for (const auto& [mass, of_B] : {std::pair("1", 0U), std::pair("1e-9", 3U), std::pair("1e-30", 3U)}) {
    for (const OptimisedFunction& made : that_divide_by_pivots(arm_with_link_of_mass(mass))) {
      EXPECT_EQ(made.function.pivot_scales.size(), made.function.task.rows.size() + of_B)
          << made.function.name << ", " << mass;
      EXPECT_EQ(made.function.proven_pivot_share > 0, of_B == 0) << made.function.name << ", " << mass;
    }
  }
}

// Their numbers, and the size of the loop's Jacobian, are not known.
TEST(LostPivots, AreCheckedOfRobotsWithSymbolsAndLoops) {
  for (const char* robot : {"planar_2r.toml", "andrews_squeezer.toml"}) {
    PipelineOptions options;
    options.functions = {"forward_dynamics"};
    Progress quiet(true);
    Diagnostics none;
    const Function function = make_functions(testing::model_of(robot), options, quiet, none).front().function;
    EXPECT_FALSE(function.pivot_scales.empty()) << robot;
    EXPECT_EQ(function.proven_pivot_share, 0) << robot;
  }
}

// Near the stretched pose, 1e-9 rad from singular, J B^-1 J^T has a pivot that is only rounding error.
TEST(LostPivots, AreCheckedInTheOperationalSpaceOfAnyArm) {
  const LoadedRobot arm = testing::model_of_toml(R"(
[[link]]
mass = 1
com = [0.5, 0, 0]
[[link]]
xyz = [1, 0, 0]
mass = 1
com = [0.5, 0, 0]
[tip]
xyz = [1, 0, 0]
)");
  PipelineOptions options;
  options.functions = {"operational_inertia"};
  Progress quiet(true);
  Diagnostics none;
  const std::vector<Function> functions = functions_of(make_functions(arm, options, quiet, none));
  const CompiledFunctions compiled(arm.mechanism, functions);
  State state = random_states(arm.mechanism, 1, 1).front();
  for (const double q2 : {1.1925454989639916e-9, 1e-10, 3e-9, 1e-12}) {
    state.q = {1.6057098304459343, q2};
    EXPECT_TRUE(std::isnan(compiled.call(0, state)[0])) << q2;
  }
  for (const double q2 : {1e-5, 1e-3, 1.0}) {
    state.q = {1.6057098304459343, q2};
    EXPECT_FALSE(std::isnan(compiled.call(0, state)[0])) << q2;
  }
}

Function forward_dynamics_of(const LoadedRobot& model) {
  PipelineOptions options;
  options.functions = {"forward_dynamics"};
  Progress quiet(true);
  Diagnostics none;
  return make_functions(model, options, quiet, none).front().function;
}

// A mass at the tip, above the first joint's axis: b_11, at most some 5 kg m², is what is left of terms of that size,
// so that b_11 itself is only rounding error.
TEST(LostPivots, AreSeenWhereADiagonalEntryIsWhatIsLeftOfLargeTerms) {
  const LoadedRobot arm = testing::model_of_toml(R"(
gravity = [0, 0, -9.81]
[[link]]
[[link]]
xyz = [0.1, 0, 0.3]
rpy = ["pi/2", 0, 0]
[[link]]
xyz = [1, 0, 0]
mass = 1.3
com = [0.7, 0, 0]
)");
  const Function function = forward_dynamics_of(arm);
  GraphEvaluator<double> rounded(function);
  GraphEvaluator<Real50> exact(function);
  int refused = 0;
  for (State& state : random_states(arm.mechanism, 200, 1)) {
    const double a = 1 + 0.7 * std::cos(state.q[2]), b = -0.7 * std::sin(state.q[2]);
    state.q[1] = std::atan2(b, a) + std::acos(-0.1 / std::hypot(a, b));
    state.qd = {0, 0, 0};
    const auto result = rounded(state);
    refused += !result;
    if (!result) continue;
    const double right = exact(widened<Real50>(state))->front().convert_to<double>();
    EXPECT_NEAR(result->front(), right, 0.1 * std::abs(right));
  }
  EXPECT_GT(refused, 100);
  State apart = random_states(arm.mechanism, 1, 1).front();
  apart.q = {0.3, 0.5, 1};
  EXPECT_TRUE(rounded(apart).has_value());
}

// A four-bar whose crank and rocker have no mass, with a point mass on the coupler's far pin: at its dead centres the
// crank turns while the mass stands still, so that b_11 is what is left of the coupler's and the rocker's motions.
TEST(LostPivots, AreSeenAtDeadCentresOfClosedLoops) {
  const LoadedRobot model = testing::model_of_toml(R"(
gravity = [0, -9.81, 0]
[[link]]
name = "crank"
joint = "a"
[[link]]
name = "coupler"
joint = "b"
xyz = [0.3, 0, 0]
mass = 1.1
com = [0.71, 0, 0]
[[link]]
name = "rocker"
joint = "c"
parent = "base"
xyz = [0.6, 0, 0]
[[loop]]
links = ["coupler", "rocker"]
from = [0.71, 0, 0]
to = [0.53, 0, 0]
dependent = ["b", "c"]
[assembly]
a = 1
b = -0.5
c = 1.2
)");
  const Function function = forward_dynamics_of(model);
  GraphEvaluator<double> rounded(function);
  GraphEvaluator<Real50> exact(function);
  State state = random_states(model.mechanism, 1, 1).front();
  state.qd = {0.3};
  state.tau = {1};
  int refused = 0;
  for (int k = 0; k < 60; ++k) {
    const double off = std::pow(10, -2 - 0.15 * k);
    state.q = {4.1859715467173189, 3.141592653589793 + off, 2.4089301589868488};
    const auto result = rounded(state);
    refused += !result;
    const auto right = exact(widened<Real50>(state));
    if (!result || !right) continue;
    const double expected = right->front().convert_to<double>();
    EXPECT_NEAR(result->front(), expected, 0.1 * std::abs(expected)) << off;
  }
  EXPECT_GT(refused, 5);
  EXPECT_LT(refused, 55);
}

// Beside what slides by 1e160 m a pivot is infinite, and what is divided by it is zero.
TEST(LostPivots, AreThoseThatOverflow) {
  const LoadedRobot arm = testing::model_of_toml(R"(
[[link]]
mass = 1
com = [0.1, 0, 0]
inertia_about = "com"
inertia = { xx = 0.1, yy = 0.1, zz = 0.1 }
[[link]]
type = "prismatic"
rpy = ["pi/2", 0, 0]
mass = 2
com = [0, 0, 0.1]
inertia_about = "com"
inertia = { xx = 0.1, yy = 0.1, zz = 0.1 }
limits = { lower = -1, upper = 1 }
)");
  const Function function = forward_dynamics_of(arm);
  EXPECT_GT(function.proven_pivot_share, 0);
  GraphEvaluator<double> rounded(function);
  State state = random_states(arm.mechanism, 1, 1).front();
  state.qd = {0, 0};
  state.q = {0.1, 1e160};
  EXPECT_FALSE(rounded(state).has_value());
  state.q = {0.1, 1e10};
  EXPECT_TRUE(rounded(state).has_value());
}

// An upright arm does not ask for it: its pivots depend on angles alone.
TEST(LostPivots, DoNotOverflowWithoutPrismaticJoints) {
  const Function function = forward_dynamics_of(testing::model_of("ur5.urdf"));
  EXPECT_EQ(function.validity_conditions.size(), 6U);
}

TEST(LostPivots, AreTold) {
  for (const auto& [mass, notes] : {std::pair("1", 0U), std::pair("1e-9", 0U), std::pair("1e-30", 1U)}) {
    PipelineOptions options;
    options.functions = {"forward_dynamics"};
    Progress quiet(true);
    Diagnostics found;
    make_functions(arm_with_link_of_mass(mass), options, quiet, found);
    EXPECT_EQ(found.all().size(), notes) << mass;
  }
}

TEST(LostPivots, AreNoErrorsOfTheCode) {
  const LoadedRobot model = arm_with_link_of_mass("1e-30");
  Progress quiet(true);
  VerifyOptions options;
  options.states = 10;
  const VerifyReport report =
      verify(model.robot, model.mechanism, functions_of(that_divide_by_pivots(model)), options, quiet);
  EXPECT_TRUE(report.passed()) << to_text(report);
  EXPECT_GT(report.functions.front().refused, 10U);
  EXPECT_THAT(to_text(report), ::testing::HasSubstr("a pivot is lost in rounding"));
}

// The check is in the text, in every language and form, and is read back.
TEST(LostPivots, AreCheckedInEveryForm) {
  const LoadedRobot model = arm_with_link_of_mass("1e-12");
  const testing::PrintedCode code(model, kThatDivide);
  const std::string header = code.text({});
  EXPECT_THAT(header, ::testing::HasSubstr("Scalar(0.015625) * "));
  EXPECT_THAT(header, ::testing::HasSubstr("lost in rounding"));
  for (const char* form : {"c++", "pair", "javascript", "c", "float"}) {
    for (const int most_lines : {0, 60}) {
      code.prove(code.text(testing::form_of(form, most_lines)), testing::form_of(form));
    }
  }
}

}  // namespace
}  // namespace flatdyn
