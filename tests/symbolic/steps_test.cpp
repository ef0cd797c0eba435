// SPDX-License-Identifier: GPL-2.0-or-later
// Steps in time: proven, of their order, and with sines of angles that the function computes.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "base/diagnostics/diagnostics.hpp"
#include "functions/exact_proof.hpp"
#include "functions/formulation.hpp"
#include "functions/function_table.hpp"
#include "graph/count.hpp"
#include "graph/tape.hpp"
#include "support/robot_models.hpp"

namespace flatdyn {
namespace {

std::vector<std::string> names_of_steps() {
  std::vector<std::string> names;
  for (const FunctionRow& row : function_table()) {
    if (std::string(row.name).starts_with("step")) names.emplace_back(row.name);
  }
  return names;
}

class Steps : public ::testing::TestWithParam<const char*> {
 protected:
  Mechanism mechanism_ = testing::model_of(GetParam()).mechanism;
};

TEST_P(Steps, AreProvenInEveryFormulation) {
  ASSERT_EQ(names_of_steps().size(), 6U);
  for (const std::string& name : names_of_steps()) {
    for (FormulationIndex way = 0; way < kFormulationCount; ++way) {
      const auto function = formulation(mechanism_, name, way, plain_choices(mechanism_));
      if (!function) continue;
      const ExactResult result = prove_exactly(mechanism_, *function, {.points = 1});
      EXPECT_TRUE(result.equal) << name << ", way " << way << ": " << result.summary();
    }
  }
}

// A part of a step that is a little too long, or a weight that is not right, is seen in each entry.
TEST_P(Steps, AreRefutedWhereTheyAreWrong) {
  for (const std::string& name : names_of_steps()) {
    Function function = derive_function(mechanism_, name);
    const NodeId h = function.graph.input({InputKind::h, 0});
    NodeId& entry = function.outputs.front().entries.back();
    entry = function.graph.sum({{1, entry}, {Rational(1, 1000000), h}});
    EXPECT_FALSE(prove_exactly(mechanism_, function, {.points = 1}).equal) << name;
  }
}

// Revolute, prismatic and coupled joints, motors, free symbols. Friction and springs are in springs_test.cpp.
INSTANTIATE_TEST_SUITE_P(Robots, Steps,
                         ::testing::Values("planar_2r.toml", "planar_2r_absolute.toml", "cartesian_2.toml",
                                           "prismatic_revolute.toml", "scara.toml"));

// The double pendulum of the textbook with the numbers of Example 7.2.
class Motion {
 public:
  explicit Motion(const std::string& function)
      : step_(derive_function(testing::model_of("planar_2r_example_7_2.toml").mechanism, function)) {}

  // Positions and rates after a step of length h from those here, with the argument qd_end.
  std::vector<double> after(const std::vector<double>& x, double h, const std::vector<double>& qd_end = {0, 0}) {
    const std::vector<double> q(x.begin(), x.begin() + 2), qd(x.begin() + 2, x.begin() + 4), tau = {1.0, -2.0},
                                                                                             length = {h};
    TapeInputs given;
    given[InputKind::q] = q;
    given[InputKind::qd] = qd;
    given[InputKind::tau] = tau;
    given[InputKind::h] = length;
    given[InputKind::qd_end] = qd_end;
    std::vector<double> next(step_.results());
    EXPECT_TRUE(step_.run(given, next));
    return next;
  }

  // The motion over a time in so many steps.
  std::vector<double> over(double time, int steps) {
    std::vector<double> x = {0.3, -0.8, 1.5, 0.4};
    for (int k = 0; k < steps; ++k) x = after(x, time / steps);
    return x;
  }

 private:
  Tape step_;
};

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t k = 0; k < 4; ++k) largest = std::max(largest, std::abs(a[k] - b[k]));
  return largest;
}

// How much smaller the error becomes with half the step.
double gain(const std::string& function) {
  constexpr double kTime = 0.1;
  const std::vector<double> truth = Motion("step:rk4").over(kTime, 4000);
  Motion motion(function);
  return distance(motion.over(kTime, 20), truth) / distance(motion.over(kTime, 40), truth);
}

TEST(StepOrders, AreThoseOfTheMethods) {
  EXPECT_NEAR(gain("step:semi_implicit_euler"), 2, 0.1);
  EXPECT_NEAR(gain("step:rk4"), 16, 1);
}

// Newton's method converges quadratically, and the midpoint rule is symmetric: a step back ends at the start.
TEST(ImplicitMidpoint, ConvergesToASymmetricStep) {
  Motion motion("step:implicit_midpoint");
  const double h = 0.02;
  const auto solved = [&](const std::vector<double>& x, double step) {
    std::vector<double> next = x, qd_end = {x[2], x[3]};
    std::vector<double> residuals;
    for (int k = 0; k < 5; ++k) {
      next = motion.after(x, step, qd_end);
      qd_end = {next[2], next[3]};
      residuals.push_back(std::max(std::abs(next[4]), std::abs(next[5])));
    }
    EXPECT_GT(residuals[0], 1);
    EXPECT_LT(residuals[1], 1e-2 * residuals[0]);
    EXPECT_LT(residuals[4], 1e-9);
    return next;
  };
  const std::vector<double> start = {0.3, -0.8, 1.5, 0.4};
  EXPECT_LT(distance(solved(solved(start, h), -h), start), 1e-12);
}

// Made from A and B, with a column by h; the graph of the step alone would take several times as many operations.
TEST(JacobiansOfSteps, AreThoseOfTheStateAndTheStepLength) {
  const Mechanism mechanism = testing::model_of("ur5.urdf").mechanism;
  for (const std::string method : {"semi_implicit_euler", "rk4"}) {
    const Function jacobian = derive_function(mechanism, "jac:step:" + method);
    const ExactResult result = prove_exactly(mechanism, jacobian, {.points = 1});
    EXPECT_TRUE(result.equal) << method << ": " << result.summary();
    const auto count = [&mechanism](const std::string& name) {
      return count_operations(derive_function(mechanism, name)).arithmetic();
    };
    EXPECT_LT(count_operations(jacobian).arithmetic(),
              count("step_derivatives:" + method) + 4 * count("step:" + method));
  }
}

TEST(StepsOf, OtherRobotsAreRefused) {
  try {
    derive_function(testing::model_of("four_bar.toml").mechanism, "step:rk4");
    FAIL();
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.kind(), FailureKind::unsupported);
    EXPECT_STREQ(failure.what(), "function \"step:rk4\" is not there for robots with closed loops");
  }
  EXPECT_THROW(derive_function(testing::model_of("scara.toml").mechanism, "step:rk45"), Failure);
  EXPECT_THROW(derive_function(testing::model_of("scara.toml").mechanism, "jac:step_derivatives:rk4"), Failure);
}

}  // namespace
}  // namespace flatdyn
