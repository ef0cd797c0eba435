// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/closed_functions.hpp"

#include <gtest/gtest.h>

#include "functions/exact_proof.hpp"
#include "functions/function_table.hpp"
#include "functions/planning/formulations.hpp"
#include "functions/planning/make_functions.hpp"
#include "graph/count.hpp"

namespace flatdyn {
namespace {

Mechanism mechanism_of(const std::string& robot) {
  return load_robot(FLATDYN_SOURCE_DIR "/robots/" + robot, {}).mechanism;
}

constexpr const char* kFunctions[] = {"inverse_dynamics", "inertia_matrix", "christoffel",   "coriolis_matrix",
                                      "gravity",          "bias",           "kinetic_energy"};

std::optional<Function> variant(const Mechanism& mechanism, const Function& recursive) {
  return closed_variant(mechanism, recursive, row_of(recursive).derivation.closed_form);
}

class ClosedVariant : public ::testing::TestWithParam<const char*> {};

TEST_P(ClosedVariant, IsTheLagrangianAndTheRecursion) {
  const Mechanism mechanism = mechanism_of(GetParam());
  for (const char* name : kFunctions) {
    const Function recursive = derive_function(mechanism, name);
    const std::optional<Function> closed = variant(mechanism, recursive);
    ASSERT_TRUE(closed.has_value()) << name;
    EXPECT_TRUE(prove_exactly(mechanism, *closed).equal) << name;
    EXPECT_TRUE(prove_equal(*closed, recursive).equal) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, ClosedVariant,
                         ::testing::Values("pendulum_motor.toml", "cartesian_2.toml", "planar_2r.toml",
                                           "planar_2r_example_7_2.toml", "prismatic_revolute.toml"),
                         [](const auto& test) {
                           const std::string name = test.param;
                           return name.substr(0, name.find('.'));
                         });

TEST(ClosedVariants, IsNotTriedWhereItWouldBeLong) {
  const Mechanism scara = mechanism_of("scara.toml");
  EXPECT_FALSE(variant(scara, derive_function(scara, "gravity")).has_value());
  const Mechanism arm = mechanism_of("planar_2r.toml");
  EXPECT_FALSE(variant(arm, derive_function(arm, "jacobian")).has_value());
}

// (7.31) with the numbers of Example 7.2: a quadratic form with one cosine; the recursion needs three multiplications
// more.
TEST(ClosedVariants, IsWhatThePlanarArmsEnergyIsEmittedFrom) {
  const LoadedRobot model = load_robot(FLATDYN_SOURCE_DIR "/robots/planar_2r_example_7_2.toml", {});
  PipelineOptions options;
  options.functions = {"kinetic_energy"};
  Progress quiet(true);
  Diagnostics left_out;
  EXPECT_EQ(count_operations(make_functions(model, options, quiet, left_out).at(0).function).multiplications, 7);
}

// cos(q_1 + q_2) of a rounded angle loses as many digits as the joints have turned.
TEST(ClosedVariants, TakesNoSineOfASum) {
  const LoadedRobot model = load_robot(FLATDYN_SOURCE_DIR "/robots/planar_2r.toml", {});
  const std::optional<Function> closed = variant(model.mechanism, derive_function(model.mechanism, "gravity"));
  ASSERT_TRUE(closed);
  for (NodeId id = 0; id < closed->graph.size(); ++id) {
    const Node& node = closed->graph[id];
    if (node.op != Op::sin && node.op != Op::cos) continue;
    EXPECT_EQ(closed->graph[node.operands[0]].op, Op::input);
  }
}

}  // namespace
}  // namespace flatdyn
