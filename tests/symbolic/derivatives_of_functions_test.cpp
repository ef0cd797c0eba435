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
#include "support/agreement.hpp"
#include "support/floating_robots.hpp"
#include "support/robot_models.hpp"
#include "support/spherical_robots.hpp"
#include "support/written_model.hpp"

namespace flatdyn {
namespace {

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
    const bool takes_long =
        std::string(row.name).ends_with("_derivatives") || row.traits.uses_base_parameters || row.traits.leaves_rest;
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
      for (FormulationIndex way = 0; way < kFormulationCount; ++way) {
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

void expect_differences(const LoadedRobot& model, const std::vector<std::string>& functions) {
  PipelineOptions options;
  for (const std::string& function : functions) {
    for (const std::string& name : derivatives_of(*find_row(function))) options.functions.push_back(name);
  }
  Progress silent(true);
  Diagnostics none;
  const ExpectedValues expected(model.robot, model.mechanism, 1);
  std::vector<State> states = with_parameters(random_states(model.mechanism, 1, 7), expected.symbols());
  const std::vector<Function> made = functions_of(make_functions(model, options, silent, none));
  draw_own_arguments(states, made, 5);
  for (const Function& function : made) testing::expect_the_reference(expected, model.mechanism, function, states);
}

TEST_P(Derivatives, AgreeWithDifferencesIn50Digits) { expect_differences(model_, {"gravity", "inverse_dynamics"}); }

TEST(DerivativesOfQuotients, AgreeWithDifferencesIn50Digits) {
  expect_differences(testing::model_of("finger.toml"), {"forward_dynamics"});
  expect_differences(testing::model_of("slider_crank.toml"), {"forward_dynamics", "loop_motion"});
}

INSTANTIATE_TEST_SUITE_P(
    Robots, Derivatives,
    ::testing::Values(  // All numbers of the SCARA are free symbols.
        DerivativeSubject{"scara", [] { return testing::model_of("scara.toml"); }, true},
        DerivativeSubject{"finger", [] { return testing::model_of("finger.toml"); }, true},
        DerivativeSubject{"slider_crank", [] { return testing::model_of("slider_crank.toml"); }, true},
        DerivativeSubject{"five_bar_hopper", [] { return testing::model_of("../docs/examples/five_bar_hopper.toml"); },
                          false},
        DerivativeSubject{"lander", [] { return testing::model_of_toml(testing::kLander); }, false},
        DerivativeSubject{"floating_ball",
                          [] { return testing::model_of_toml(std::string(testing::kTrunk) + testing::kHanging); },
                          false}),
    [](const auto& each) { return std::string(each.param.name); });

// Gravity does not act on armature, so that it is no acceleration of the base.
TEST(DerivativesOfStructure, AreProvenWhereTheBaseHasArmature) {
  const Mechanism mechanism = testing::model_of_toml(testing::heavy_satellite()).mechanism;
  for (const char* name : {"jac:inverse_dynamics", "jac:forward_dynamics", "vjp:forward_dynamics"}) {
    const ExactResult result = prove_exactly(mechanism, derive_function(mechanism, name), {.points = 1});
    EXPECT_TRUE(result.equal) << name << ": " << result.summary();
  }
}

bool is_proven(const Mechanism& mechanism, const Function& function) {
  try {
    return prove_exactly(mechanism, function).equal;
  } catch (const Failure&) {
    return false;  // it has another shape
  }
}

// An entry of each kind of derivatives has a term too many, they are those of another function, a matrix is missing.
TEST(DerivativesProof, FindsWhatIsWrong) {
  const Mechanism mechanism = testing::model_of("scara.toml").mechanism;
  for (const Derivative derivative : kDerivatives) {
    const std::string name = prefix_of(derivative) + ":bias";
    Function function = derive_function(mechanism, name);
    EXPECT_TRUE(prove_exactly(mechanism, function).equal) << name;
    NodeId& entry = function.outputs.back().entries.back();
    entry = function.graph.sum({{1, entry}, {1, function.graph.input({InputKind::q, 0})}});
    const ExactResult result = prove_exactly(mechanism, function);
    ASSERT_EQ(result.mismatches.size(), 1U) << name;
    EXPECT_EQ(result.mismatches[0].output, function.outputs.back().name);
    Function of_another = derive_function(mechanism, prefix_of(derivative) + ":gravity");
    of_another.name = prefix_of(derivative) + ":potential_energy";
    EXPECT_FALSE(is_proven(mechanism, of_another)) << name;
  }
  Function hessian = derive_function(mechanism, "hessian:bias");
  hessian.outputs.pop_back();
  EXPECT_FALSE(is_proven(mechanism, hessian));
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

// Derivatives of accelerations are made from those of torques at the solution.
TEST(DerivativesCost, OfForwardDynamicsIsThatOfTheirStructure) {
  PipelineOptions options;
  options.functions = {"jac:inverse_dynamics", "jac:forward_dynamics", "vjp:forward_dynamics",
                       "hessian:forward_dynamics"};
  Progress silent(true);
  Diagnostics none;
  const auto functions = functions_of(make_functions(testing::model_of("ur5.urdf"), options, silent, none));
  EXPECT_LE(count_operations(functions[0]).arithmetic(), 960);
  EXPECT_LE(count_operations(functions[1]).arithmetic(), 1880);
  EXPECT_LE(count_operations(functions[2]).arithmetic(), 960);
  EXPECT_LE(count_operations(functions[3]).arithmetic(), 4300);
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
}

}  // namespace
}  // namespace flatdyn
