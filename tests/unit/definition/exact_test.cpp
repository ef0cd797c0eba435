// SPDX-License-Identifier: GPL-2.0-or-later
// The exact comparison accepts what is derived, and rejects every mutant of it.
#include "functions/exact_proof.hpp"

#include <gtest/gtest.h>

#include <random>

#include "base/diagnostics/diagnostics.hpp"
#include "functions/function_table.hpp"
#include "functions/planning/formulations.hpp"
#include "support/mutants.hpp"
#include "support/robot_models.hpp"
#include "support/robots.hpp"
#include "support/spare_joints.hpp"
#include "truth/definition/degree.hpp"

namespace flatdyn {
namespace {

std::vector<std::string> function_names(const Mechanism& mechanism) {
  std::vector<std::string> names;
  for (const FunctionRow& entry : function_table()) {
    if (entry.applies_to(mechanism)) names.emplace_back(entry.name);
  }
  return names;
}

// Leaves out the pivots, which differ between two factorisations.
Function with_accelerations_only(Function function) {
  function.validity_conditions.clear();
  return function;
}

TEST(ProveExactly, AcceptsEveryDerivedFunctionOfRandomTrees) {
  for (const unsigned seed : {1U, 4U, 9U}) {
    const Mechanism mechanism = make_mechanism(testing::random_tree(seed, 5));
    const Mechanism spare = testing::with_spare_joints(mechanism);
    const Choices choices = uniform_choices(mechanism, Grouping::i_yy);
    std::vector<std::string> names = function_names(mechanism);
    names.emplace_back("forward_kinematics:link2");
    names.emplace_back("jacobian:base");
    names.emplace_back("jacobian_dot_qd:link3");
    names.emplace_back("external_torque:link2");
    for (const std::string& name : names) {
      for (FormulationIndex way = 0; way < kFormulationCount; ++way) {
        const bool is_spare = name == "null_space_torque";
        const std::optional<Function> function = formulation(is_spare ? spare : mechanism, name, way, choices);
        if (!function) continue;
        const ExactResult result = prove_exactly(mechanism, *function);
        EXPECT_TRUE(result.equal) << mechanism.name << ' ' << name << ": " << result.summary();
        EXPECT_LT(result.failure_log2, -100) << result.summary();
        EXPECT_GT(result.entries, 0);
      }
    }
  }
}

// Robots with rotors on parents, with prismatic joints, with branches, and without any of these.
TEST(ProveExactly, AcceptsForwardDynamicsInEveryWay) {
  for (const char* robot : {"planar_2r_example_7_2.toml", "rx90.toml", "ur5.urdf", "quadruped12.urdf"}) {
    const Mechanism mechanism = testing::model_of(robot).mechanism;
    const std::vector<Formulation> all = formulations(mechanism, "forward_dynamics");
    ASSERT_GE(all.size(), 2u) << robot;
    for (const Formulation& each : all) {
      const ExactResult result = prove_exactly(mechanism, each.function);
      EXPECT_TRUE(result.equal) << robot << " in way " << each.way << ": " << result.summary();
      EXPECT_TRUE(prove_equal(with_accelerations_only(all[0].function), with_accelerations_only(each.function)).equal)
          << robot << " in way " << each.way;
    }
  }
}

TEST(ProveExactly, KnowsSymbolsAndTheirSines) {
  Mechanism mechanism = make_mechanism(testing::random_tree(1, 3, true));
  ASSERT_EQ(mechanism.size(), 3);
  const GiNaC::symbol m("m"), a("a"), alpha("alpha");
  for (const GiNaC::symbol& symbol : {m, a, alpha}) mechanism.symbols.push_back({symbol, symbol.get_name(), {}});
  mechanism.bodies[1].alpha = {GiNaC::cos(2 * alpha + 1), GiNaC::sin(2 * alpha + 1)};
  mechanism.bodies[1].p[0] = 1 / (a + 1);
  mechanism.bodies[2].inertia.mass = m;
  for (const char* name : {"inverse_dynamics", "forward_dynamics", "christoffel"}) {
    const ExactResult result = prove_exactly(mechanism, derive_function(mechanism, name));
    EXPECT_TRUE(result.equal) << name << ": " << result.summary();
  }
}

TEST(ProveExactly, RejectsAnotherRobot) {
  Robot robot = testing::random_tree(4, 4, true);
  const Mechanism mechanism = make_mechanism(robot);
  robot.links.back().inertials[0].mass.number += Number(1) / 1000000000;
  const Mechanism heavier = make_mechanism(robot);
  for (const char* name : {"inverse_dynamics", "inertia_matrix", "gravity", "forward_dynamics", "potential_energy"}) {
    EXPECT_FALSE(prove_exactly(heavier, derive_function(mechanism, name)).equal) << name;
  }
}

TEST(ProveExactly, NamesTheEntryThatIsWrong) {
  const Mechanism mechanism = make_mechanism(testing::random_tree(1, 4, true));
  Function function = derive_function(mechanism, "inertia_matrix");
  const auto n = static_cast<std::size_t>(mechanism.size());
  ASSERT_GE(n, 2U);
  NodeId& entry = function.outputs[0].entries[n + 1];
  entry = function.graph.scaled(-1, entry);
  const ExactResult result = prove_exactly(mechanism, function);
  ASSERT_EQ(result.mismatches.size(), 1U);
  EXPECT_EQ(result.mismatches[0].output, "B");
  EXPECT_EQ(result.mismatches[0].row, 1);
  EXPECT_EQ(result.mismatches[0].col, 1);
  EXPECT_EQ(result.summary(),
            std::to_string(1) + " of " + std::to_string(n * n) + " entries differ, the first is B[1, 1]");
}

TEST(ProveExactly, RefusesAFunctionItDoesNotKnow) {
  const Mechanism mechanism = make_mechanism(testing::random_tree(1, 2, true));
  Function function = derive_function(mechanism, "gravity");
  function.name = "levity";
  EXPECT_THROW(prove_exactly(mechanism, function), Failure);
}

// A dropped term, a flipped sign and a cosine replaced by a sine, at every node that has them.
TEST(ProveExactly, CatchesEveryMutant) {
  const Mechanism mechanism = make_mechanism(testing::random_tree(1, 3, true));
  ExactOptions quick;
  quick.points = 1;
  int mutants = 0;
  for (const char* name :
       {"inverse_dynamics", "inertia_matrix", "christoffel", "forward_dynamics", "jacobian_dot_qd"}) {
    const Function function = derive_function(mechanism, name);
    const std::vector<bool> alive = reachable_from(function.graph, roots(function));
    ASSERT_TRUE(prove_equal(function, testing::mutant(function, -1, testing::MutantKind::drop_term), quick).equal);
    for (NodeId id = 0; id < function.graph.size(); ++id) {
      if (!alive[static_cast<std::size_t>(id)]) continue;
      const Op op = function.graph[id].op;
      std::vector<testing::MutantKind> mutations;
      if (op == Op::sum) mutations = {testing::MutantKind::flip_sign, testing::MutantKind::drop_term};
      if (op == Op::sin || op == Op::cos) mutations = {testing::MutantKind::swap_trigonometry};
      for (const testing::MutantKind mutation : mutations) {
        const Function wrong = testing::mutant(function, id, mutation);
        EXPECT_FALSE(prove_equal(function, wrong, quick).equal) << name << " node " << id;
        ++mutants;
      }
      if (op == Op::sum && id % 5 == 0) {
        EXPECT_FALSE(
            prove_exactly(mechanism, testing::mutant(function, id, testing::MutantKind::drop_term), quick).equal)
            << name << " node " << id;
      }
    }
  }
  EXPECT_GT(mutants, 300);
}

TEST(ProveEqual, SeesSwappedEntriesAndConditions) {
  const Mechanism mechanism = make_mechanism(testing::random_tree(9, 4, true));
  const Function function = derive_function(mechanism, "forward_dynamics");
  ASSERT_GE(function.validity_conditions.size(), 2U);
  EXPECT_TRUE(prove_equal(function, function).equal);
  Function swapped = function;
  std::swap(swapped.outputs[0].entries[0], swapped.outputs[0].entries[1]);
  EXPECT_EQ(prove_equal(function, swapped).mismatches.size(), 2U);
  swapped = function;
  std::swap(swapped.validity_conditions[0], swapped.validity_conditions[1]);
  const ExactResult result = prove_equal(function, swapped);
  ASSERT_EQ(result.mismatches.size(), 2U);
  EXPECT_EQ(result.mismatches[0].output, "positive");
  swapped.outputs[0].entries.pop_back();
  EXPECT_FALSE(prove_equal(function, swapped).equal);
}

TEST(ProveEqual, HoldsTheAdditionTheorems) {
  Function products, sum;
  const auto inputs = [](Graph& g) { return std::pair(g.input({InputKind::q, 0}), g.input({InputKind::q, 1})); };
  const auto [x, y] = inputs(products.graph);
  Graph& g = products.graph;
  const NodeId c = g.sum({{1, g.product({g.cos(x), g.cos(y)})}, {-1, g.product({g.sin(x), g.sin(y)})}});
  products.outputs.push_back({"c", Layout::scalar, 1, 1, {c}, ""});
  const auto [u, v] = inputs(sum.graph);
  sum.outputs.push_back({"c", Layout::scalar, 1, 1, {sum.graph.cos(sum.graph.sum({{1, u}, {1, v}}))}, ""});
  EXPECT_TRUE(prove_equal(products, sum).equal);
  sum.outputs[0].entries[0] = sum.graph.cos(sum.graph.sum({{1, u}, {-1, v}}));
  EXPECT_FALSE(prove_equal(products, sum).equal);
}

// (q x + 1)² / (x + y): numerator 4, denominator 1.
TEST(Degrees, OfAQuotient) {
  Function function;
  Graph& g = function.graph;
  const NodeId q = g.input({InputKind::qd, 0}), x = g.input({InputKind::qd, 1}), y = g.input({InputKind::qd, 2});
  const NodeId square = g.sum({{1, g.product({q, x})}}, 1);
  const NodeId below = g.sum({{1, x}, {1, y}});
  const NodeId ratio = g.quotient(g.product({square, square}), below);
  function.outputs.push_back({"r", Layout::scalar, 1, 1, {ratio}, ""});
  EXPECT_EQ(function_degrees(function).numerator, 4);
  EXPECT_EQ(function_degrees(function).denominator, 1);
  function.outputs[0].entries[0] = g.sum({{1, ratio}, {1, g.product({q, q, q, q, q})}});
  EXPECT_EQ(function_degrees(function).numerator, 6);
}

}  // namespace
}  // namespace flatdyn
