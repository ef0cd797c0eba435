// SPDX-License-Identifier: GPL-2.0-or-later
// The proof that generate makes before it writes: right functions pass, and a mistake after any pass is caught.
#include "proof/verify/proof.hpp"
#include "functions/planning/make_functions.hpp"

#include <gtest/gtest.h>

#include <random>

#include "base/diagnostics/diagnostics.hpp"
#include "functions/planning/formulations.hpp"
#include "support/mutants.hpp"
#include "support/robot_models.hpp"

namespace flatdyn {
namespace {

using testing::MutantKind;

std::vector<MutantKind> mutations_of(const Node& node) {
  if (node.op == Op::sum && node.terms.size() > 1) return {MutantKind::flip_sign, MutantKind::drop_term};
  if (node.op == Op::sin || node.op == Op::cos) return {MutantKind::swap_trigonometry};
  if (node.op == Op::input) return {MutantKind::wrong_index};
  const bool is_square = node.op == Op::product && node.operands.front() == node.operands.back();
  if (node.op == Op::product && !is_square) return {MutantKind::wrong_operand};
  return {};
}

// The function with a mistake in a node that the outputs need.
Function with_mistake(const Function& function, std::mt19937& engine) {
  const std::vector<bool> alive = reachable_from(function.graph, roots(function));
  for (;;) {
    const NodeId victim = static_cast<NodeId>(engine() % static_cast<unsigned>(function.graph.size()));
    const std::vector<MutantKind> mutations = mutations_of(function.graph[victim]);
    if (!alive[static_cast<std::size_t>(victim)] || mutations.empty()) continue;
    return testing::mutant(function, victim, mutations[engine() % mutations.size()]);
  }
}

// Runs the passes in order, with a mistake in the result of pass `faulty`.
Function through_passes(Function function, std::size_t faulty, std::mt19937& engine) {
  const std::vector<Pass>& passes = pass_table();
  for (std::size_t k = 0; k < passes.size(); ++k) {
    function = passes[k].run(function);
    if (k == faulty) function = with_mistake(function, engine);
  }
  return function;
}

TEST(Proof, CatchesAMistakeInAnyPass) {
  const Mechanism mechanism = testing::model_of("ur5.urdf").mechanism;
  std::mt19937 engine(1);
  int mutants = 0;
  for (const char* name : {"inverse_dynamics", "inertia_matrix", "gravity"}) {
    const Function derived = derive_function(mechanism, name);
    for (std::size_t pass = 0; pass < pass_table().size(); ++pass) {
      for (int k = 0; k < 4; ++k, ++mutants) {
        const OptimisedFunction wrong{through_passes(derived, pass, engine), derived, {}, {}};
        EXPECT_THROW(prove(mechanism, {wrong}, {}, {}, 1), Failure)
            << name << ", mistake " << k << " in " << pass_table()[pass].name;
      }
    }
  }
  EXPECT_GE(mutants, 40);
}

TEST(Proof, CatchesAWrongConditionAndAnotherRobot) {
  const Mechanism puma = testing::model_of("puma560.toml").mechanism;
  const Function forward = derive_function(puma, "forward_dynamics");
  OptimisedFunction wrong{forward, forward, {}, {}};
  std::swap(wrong.function.validity_conditions.front(), wrong.function.validity_conditions.back());
  EXPECT_THROW(prove(puma, {wrong}, {}, {}, 1), Failure);
  Mechanism other = puma;
  other.bodies.back().inertia.mass += Number(1) / 1000;
  EXPECT_THROW(prove(other, {OptimisedFunction{forward, forward, {}, {}}}, {}, {}), Failure);
}

TEST(Proof, CoversFusedFunctionsAndStages) {
  const LoadedRobot model = testing::model_of("scara.toml");
  Progress quiet(true);
  OptimisedFusion fused = make_fusion(model, {"inertia_matrix", "gravity"}, quiet);
  Stages stages = stages_of(make_fusion(model, {"inertia_matrix", "bias", "forward_dynamics"}, quiet).fusion);
  const std::vector<Proof> proofs = prove(model.mechanism, {}, {fused}, stages);
  std::vector<std::string> names;
  for (const Proof& proof : proofs) names.push_back(proof.function);
  const std::vector<std::string> expected = {"inertia_matrix_gravity::inertia_matrix",
                                             "inertia_matrix_gravity::gravity", "at(q)::inertia_matrix", "at(q)::bias",
                                             "at(q)::forward_dynamics"};
  EXPECT_EQ(names, expected);
  Stages wrong = stages;
  std::swap(wrong.motion.make.outputs[0].entries.front(), wrong.motion.make.outputs[0].entries.back());
  EXPECT_THROW(prove(model.mechanism, {}, {}, wrong), Failure);
  std::swap(fused.fusion.function.outputs[0].entries.front(), fused.fusion.function.outputs[0].entries.back());
  EXPECT_THROW(prove(model.mechanism, {}, {fused}, {}), Failure);
}

}  // namespace
}  // namespace flatdyn
