// SPDX-License-Identifier: GPL-2.0-or-later
// Limbs that are computed together: which they are, that mirrored ones are alike, and that compilers agree.
#include "code/lower/limbs.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "code/emit/function_text.hpp"
#include "code/languages/cpp/dialect.hpp"
#include "code/lower/limb_plan.hpp"
#include "support/printed_code.hpp"
#include "support/robot_models.hpp"
#include "unit/emit/compiled.hpp"
#include "unit/emit/hand_made.hpp"

namespace flatdyn::testing {
namespace {

std::vector<Limbs> limbs_of_robot(const char* file) { return limbs_of(model_of(file).mechanism); }

TEST(LimbsOfARobot, AreItsSubtreesAlike) {
  const std::vector<Limbs> legs = limbs_of_robot("quadruped12.urdf");
  ASSERT_EQ(legs.size(), 1U);
  const std::vector<std::vector<int>> joints = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}, {9, 10, 11}};
  EXPECT_EQ(legs[0].joints, joints);
  EXPECT_EQ(legs[0].lanes(), 4);
}

TEST(LimbsOfARobot, HangOnTheBaseOrFurtherOut) {
  const std::vector<Limbs> sets = limbs_of_robot("humanoid32.urdf");
  ASSERT_EQ(sets.size(), 2U);
  EXPECT_EQ(sets[0].count(), 2);
  EXPECT_EQ(sets[1].count(), 2);
}

TEST(LimbsOfARobot, AreNoneInChainsAndLoops) {
  for (const char* file : {"panda.urdf", "four_bar.toml", "finger.toml"}) EXPECT_TRUE(limbs_of_robot(file).empty());
}

TEST(LimbsOfARobot, FillLanesToAPowerOfTwo) {
  Limbs three;
  three.joints = {{0}, {1}, {2}};
  EXPECT_EQ(three.lanes(), 4);
}

const PrintedCode& quadruped() {
  static const PrintedCode code(model_of("quadruped12.urdf"), {"inverse_dynamics"});
  return code;
}

// Two legs of quadruped12 are mirror images of the others: with the signs of some values changed, all four are alike.
TEST(LimbPlan, HasAllOfTheQuadrupedsInverseDynamicsInLanes) {
  const Function& function = quadruped().functions().front();
  Schedule schedule = make_schedule(function, std::vector<bool>(static_cast<std::size_t>(function.graph.size())));
  const auto plan = limb_plan(function, limbs_of_robot("quadruped12.urdf"), schedule);
  ASSERT_TRUE(plan);
  for (const LimbStep& step : plan->steps) EXPECT_NE(step.kind, LimbStep::Kind::scalar);
  for (const LimbStep& step : plan->steps) EXPECT_NE(step.kind, LimbStep::Kind::taken);
  EXPECT_LE(plan->gathered.size(), 9U) << "vectors of coefficients with other signs";
  for (const LimbClass& each : plan->classes.classes) {
    ASSERT_EQ(each.signs.size(), 4U);
    EXPECT_EQ(each.signs[0], 1);
    EXPECT_EQ(each.signs[2], 1) << "the legs of one side are the same";
  }
}

TEST(LimbPlan, IsNoneWhereNothingIsSaved) {
  const Function& function = quadruped().functions().front();
  Schedule schedule = make_schedule(function, std::vector<bool>(static_cast<std::size_t>(function.graph.size())));
  EXPECT_FALSE(limb_plan(function, {}, schedule));
}

const std::vector<Limbs>& two_slides() {
  static const std::vector<Limbs> sets = [] {
    Limbs slides;
    slides.joints = {{0}, {1}};
    return std::vector<Limbs>{slides};
  }();
  return sets;
}

// A polynomial in q of one of the slides, which pays for its lane.
NodeId of_slide(Builder& b, int k) {
  NodeId value = b.times({b.q(k), b.qd(k)});
  for (int degree = 0; degree < 6; ++degree) value = b.plus({b.times({value, b.q(k)}), b.qd(k)});
  return value;
}

Function torques(const Builder& b, const std::vector<NodeId>& entries) {
  Function function;
  function.name = "f";
  function.inputs = {InputKind::q, InputKind::qd, InputKind::h_e};
  function.graph = b.graph;
  function.outputs = {{"tau", Layout::vector, static_cast<int>(entries.size()), 1, entries, ""}};
  return function;
}

// Two products are alike, but the first needs the second: they are computed one after the other, all else at once.
TEST(LimbPlan, LeavesOutWhatNeedsItself) {
  Builder b;
  const NodeId x_0 = of_slide(b, 0), x_1 = of_slide(b, 1);
  const NodeId second = b.times({b.plus({x_0, x_1}), b.qd(1)});
  const NodeId first = b.times({b.plus({second, x_0}), b.qd(0)});
  const Function function = torques(b, {first, second});
  Schedule schedule = make_schedule(function, std::vector<bool>(static_cast<std::size_t>(function.graph.size())));
  const auto plan = limb_plan(function, two_slides(), schedule);
  ASSERT_TRUE(plan);
  EXPECT_FALSE(plan->classes.has(first));
  EXPECT_FALSE(plan->classes.has(second));
  EXPECT_TRUE(plan->classes.has(x_0));
}

// Outputs may overlap inputs, so that all inputs are read before the first output is written.
TEST(CodeOfLimbs, ReadsInputsBeforeItWrites) {
  Builder b;
  std::vector<NodeId> values;
  for (int k = 0; k < 2; ++k) values.push_back(of_slide(b, k));
  for (int k = 0; k < 2; ++k)
    values.push_back(b.times({values[static_cast<std::size_t>(k)], b.graph.input({InputKind::h_e, k})}));
  const Function function = torques(b, values);
  const CppDialect dialect;
  HeaderScope scope(dialect);
  scope.counts = 2;
  scope.limbs = two_slides();
  const std::string text = function_text(function, "f", scope).body;
  EXPECT_NE(text.find("const Limbs2 "), std::string::npos);
  EXPECT_LT(text.rfind("h_e["), text.find("tau[0] = ")) << text;
}

// rounding_is_as_written() compares with arithmetic lane by lane; long double has lanes of its own.
TEST(CodeOfLimbs, HasTheSameBitsByEveryCompiler) {
  EmitOptions options;
  options.limbs_in_lanes = true;
  constexpr const char* kMain = R"(
#include <cstdio>
#include "quadruped12.hpp"
template <class Scalar>
static double torque() {
  Scalar q[12], qd[12], qdd[12], tau[12];
  for (int k = 0; k < 12; ++k) {
    q[k] = Scalar(0.125) * Scalar(k) - Scalar(0.75);
    qd[k] = Scalar(0.5) - Scalar(0.25) * Scalar(k);
    qdd[k] = Scalar(k);
  }
  quadruped12::inverse_dynamics(q, qd, qdd, tau, quadruped12::LibrarySinCos());
  return static_cast<double>(tau[4] + Scalar(2.0) * tau[9]);
}
int main() {
  const double error = torque<double>() - torque<long double>();
  const bool is_near = error < 1e-14 && error > -1e-14;
  const bool is_right = quadruped12::rounding_is_as_written<double>() && quadruped12::rounding_is_as_written<float>();
  std::printf("%d %d\n", is_near ? 1 : 0, is_right ? 1 : 0);
}
)";
  for (const std::string& compiler : compilers()) {
    const auto run = build_and_run(compiler, {{"quadruped12.hpp", quadruped().text(options)}, {"main.cpp", kMain}});
    EXPECT_TRUE(run.built) << run.output;
    EXPECT_EQ(run.output, "1 1\n") << compiler;
  }
}

}  // namespace
}  // namespace flatdyn::testing
