// SPDX-License-Identifier: GPL-2.0-or-later
// Derivatives of every function, and their products with vectors, of robots of all kinds: against dual numbers over the
// definition, against differences in 50 digits, and by how many operations they take.
#include <gtest/gtest.h>

#include <filesystem>

#include "base/diagnostics/diagnostics.hpp"
#include "functions/deviation/expected.hpp"
#include "functions/exact_proof.hpp"
#include "functions/function_table.hpp"
#include "functions/planning/formulations.hpp"
#include "functions/planning/make_functions.hpp"
#include "graph/count.hpp"
#include "graph/function_name.hpp"
#include "graph/fusion.hpp"
#include "robot/model/states.hpp"
#include "support/floating_robots.hpp"
#include "support/robot_models.hpp"
#include "support/written_model.hpp"
#include "truth/reference/graph_evaluator.hpp"

namespace flatdyn {
namespace {

// A ball on an arm whose base floats.
constexpr const char* kFloatingBall = R"(
[base]
name = "trunk"
motion = "floating"
mass = 5
com = [0.02, 0.01, 0]
inertia = { xx = 0.1, yy = 0.3, zz = 0.35, xz = 0.02 }
inertia_about = "com"
[[link]]
name = "bob"
joint = "ball"
type = "spherical"
xyz = [0.1, 0.2, 0]
mass = 1.5
com = [0, 0.1, -0.4]
inertia = { xx = 0.02, yy = 0.03, zz = 0.01, xy = 0.002 }
inertia_about = "com"
viscous = 0.01
[[link]]
joint = "slide"
type = "prismatic"
xyz = [0, 0.1, -0.8]
rpy = [0.4, 0, 0]
mass = 0.5
com = [0.1, 0, 0.2]
inertia = { xx = 0.02, yy = 0.03, zz = 0.01 }
inertia_about = "com"
)";

struct DerivativeSubject {
  const char* name;
  LoadedRobot (*model)();
  bool has_all_functions;  // whether those that take long are looked at, too
};

std::vector<std::string> derivatives_of(const FunctionRow& row) {
  std::vector<std::string> names;
  for (const Derivative derivative : kDerivatives) names.push_back(prefix_of(derivative) + ":" + row.name);
  return names;
}

class Derivatives : public ::testing::TestWithParam<DerivativeSubject> {
 protected:
  bool has(const FunctionRow& row) const {
    const bool takes_long = std::string(row.name).ends_with("_derivatives") || row.traits.uses_base_parameters;
    const bool is_singular = row.traits.uses_task && mechanism_.size() < 6;
    return row.applies_to(mechanism_) && find_row(derivatives_of(row)[0]) != nullptr && !is_singular &&
           (GetParam().has_all_functions || !takes_long);
  }

  LoadedRobot model_ = GetParam().model();
  const Mechanism& mechanism_ = model_.mechanism;
};

// In each of the ways in which the function can be derived.
TEST_P(Derivatives, AreProven) {
  int proven = 0;
  for (const FunctionRow& row : function_table()) {
    if (!has(row)) continue;
    for (const std::string& name : derivatives_of(row)) {
      for (FormulationIndex way = 0; way <= row.derivation.alternatives.size(); ++way) {
        const auto function = formulation(mechanism_, name, way, uniform_choices(mechanism_, Grouping::i_yy));
        if (!function) continue;
        const ExactResult result = prove_exactly(mechanism_, *function, {.points = 1});
        EXPECT_TRUE(result.equal) << name << ", way " << way << ": " << result.summary();
        ++proven;
      }
    }
  }
  EXPECT_GT(proven, 20);
}

TEST_P(Derivatives, AgreeWithDifferencesIn50Digits) {
  PipelineOptions options;
  for (const char* const function : {"gravity", "forward_dynamics"}) {
    for (const std::string& name : derivatives_of(*find_row(function))) options.functions.push_back(name);
  }
  Progress silent(true);
  Diagnostics none;
  const ExpectedValues expected(model_.robot, mechanism_, 1);
  std::vector<State> states = with_parameters(random_states(mechanism_, 1, 7), expected.symbols());
  const std::vector<Function> functions = functions_of(make_functions(model_, options, silent, none));
  draw_own_arguments(states, functions, 5);
  for (const Function& function : functions) {
    const Expected here = expected.of(function);
    for (const State& state : states) {
      const auto values = GraphEvaluator<Real50>(function)(with_unit_quaternions(mechanism_, widened<Real50>(state)));
      const std::vector<Real50> right = here.exact(state);
      const std::vector<double> scale = here.scale(state);
      ASSERT_TRUE(values) << function.name;
      ASSERT_EQ(values->size(), right.size()) << function.name;
      for (std::size_t k = 0; k < right.size(); ++k) {
        const Real50 difference = abs((*values)[k] - right[k]);
        EXPECT_LE(difference.convert_to<double>(), 1e-35 * std::max(1.0, scale[k])) << function.name << " " << k;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Robots, Derivatives,
    ::testing::Values(  // All numbers of the SCARA are free symbols.
        DerivativeSubject{"scara", [] { return testing::model_of("scara.toml"); }, true},
        DerivativeSubject{"finger", [] { return testing::model_of("finger.toml"); }, true},
        DerivativeSubject{"lander", [] { return testing::model_of_toml(testing::kLander); }, false},
        DerivativeSubject{"floating_ball", [] { return testing::model_of_toml(kFloatingBall); }, false}),
    [](const auto& each) { return std::string(each.param.name); });

// A product that lacks a term is found, and so is one that is right for another function.
TEST(DerivativesProof, FindsWhatIsWrong) {
  const Mechanism mechanism = testing::model_of("scara.toml").mechanism;
  for (const std::string name : {"vjp:inverse_dynamics", "jvp:inverse_dynamics"}) {
    Function function = derive_function(mechanism, name);
    EXPECT_TRUE(prove_exactly(mechanism, function).equal);
    Function another = derive_function(mechanism, name.substr(0, 4) + "bias");
    std::swap(function.graph, another.graph);
    std::swap(function.outputs[0].entries, another.outputs[0].entries);
    for (std::size_t k = 1; k < function.outputs.size(); ++k) {
      for (NodeId& entry : function.outputs[k].entries) entry = function.outputs[0].entries[0];
    }
    EXPECT_FALSE(prove_exactly(mechanism, function).equal) << name;
  }
  Function function = derive_function(mechanism, "vjp:gravity");
  NodeId& entry = function.outputs[0].entries.back();
  entry = function.graph.sum({{1, entry}, {1, function.graph.input({InputKind::weights, 0})}});
  const ExactResult result = prove_exactly(mechanism, function);
  ASSERT_EQ(result.mismatches.size(), 1U);
  EXPECT_EQ(result.mismatches[0].output, "q_bar");
}

// Reverse mode needs at most a small multiple of the function's operations, whatever the number of arguments.
TEST(DerivativesCost, OfInverseDynamicsOfThePandaIsASmallMultipleOfTheFunction) {
  PipelineOptions options;
  options.functions = {"inverse_dynamics", "vjp:inverse_dynamics", "jvp:inverse_dynamics", "hessian:inverse_dynamics"};
  Progress silent(true);
  Diagnostics none;
  const auto functions = functions_of(make_functions(testing::model_of("panda.urdf"), options, silent, none));
  const int own = count_operations(functions[0]).arithmetic();
  EXPECT_LE(count_operations(functions[1]).arithmetic(), 2.5 * own);
  EXPECT_LE(count_operations(functions[2]).arithmetic(), 2.4 * own);
  EXPECT_LE(count_operations(functions[3]).arithmetic(), 12.2 * own);
}

// Weights of two functions are not the same, even if they are as many.
TEST(DerivativesFusion, TakesOneMeaningOfWeightsOnly) {
  const Mechanism mechanism = testing::model_of("scara.toml").mechanism;
  const Function gravity = derive_function(mechanism, "gravity"),
                 of_gravity = derive_function(mechanism, "vjp:gravity"),
                 of_bias = derive_function(mechanism, "vjp:bias");
  EXPECT_EQ(fused({gravity, of_gravity}).function.own.length, 4);
  EXPECT_THROW(fused({of_gravity, of_bias}), Failure);
}

// Springs of the SCARA, which has none, are as linear in q as all springs are.
TEST(DerivativesHessian, HasAnOutputWhereAllSecondDerivativesAreZero) {
  const Function zero = derive_function(testing::model_of("scara.toml").mechanism, "hessian:spring_regressor");
  ASSERT_EQ(zero.outputs.size(), 1U);
  EXPECT_EQ(zero.outputs[0].name, "H_parameters_parameters");
}

TEST(DerivativesNames, AreThoseOfFunctionsWithAPrefix) {
  EXPECT_STREQ(find_row("vjp:jacobian:hand")->name, "vjp:jacobian");
  EXPECT_EQ(parts_of_name("vjp:jacobian:hand").link, "hand");
  EXPECT_EQ(parts_of_name("jacobian:vjp").derivative, Derivative::none);
  EXPECT_EQ(find_row("vjp:vjp"), nullptr);
  EXPECT_EQ(find_row("jvp:base_parameters"), nullptr);  // it has no arguments
  EXPECT_EQ(find_row("jvp:loop_step"), nullptr);
  const Mechanism loops = testing::model_of("five_bar.toml").mechanism;
  EXPECT_THROW(derive_function(loops, "vjp:gravity"), Failure);
}

}  // namespace
}  // namespace flatdyn
