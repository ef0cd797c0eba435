// SPDX-License-Identifier: GPL-2.0-or-later
// Fusing functions and cutting the whole into stages changes no value, by comparison in GF(p) on random trees with
// rotors.
#include "code/lower/stages.hpp"

#include <gtest/gtest.h>

#include "functions/planning/formulations.hpp"
#include "graph/count.hpp"
#include "graph/evaluate.hpp"
#include "graph/mod_p.hpp"
#include "graph/passes/passes.hpp"
#include "support/robots.hpp"

namespace flatdyn {
namespace {

using Residue = ModP<kMersenne61>;

// Arithmetic in which the stored values of a stage are given and the rest is random.
struct WithStored : ModPArithmetic<> {
  WithStored(std::uint64_t seed, std::vector<Residue> fields) : ModPArithmetic<>(seed), stored(std::move(fields)) {}

  Residue input(const Input& input) const {
    return input.kind == InputKind::stored ? stored.at(static_cast<std::size_t>(input.index))
                                           : ModPArithmetic<>::input(input);
  }

  std::vector<Residue> stored;
};

std::vector<Residue> values_with(const Function& function, std::uint64_t seed,
                                 const std::vector<Residue>& stored = {}) {
  WithStored arithmetic(seed, stored);
  const std::vector<Residue> values = evaluate(function, arithmetic);
  std::vector<Residue> result;
  for (const NodeId root : roots(function)) result.push_back(values[static_cast<std::size_t>(root)]);
  return result;
}

const std::vector<std::string> kFused = {"inertia_matrix",   "gravity", "potential_energy",
                                         "inverse_dynamics", "bias",    "inverse_dynamics_tip_force",
                                         "forward_dynamics"};

Fusion optimised(const Mechanism& mechanism, const std::vector<std::string>& names) {
  const Choices choices = uniform_choices(mechanism, Grouping::i_yy);
  std::vector<Function> functions;
  for (const std::string& name : names) functions.push_back(*formulation(mechanism, name, 0, choices));
  Fusion fusion = fused(functions);
  fusion.function = run_passes(fusion.function);
  return fusion;
}

class RandomStages : public ::testing::TestWithParam<unsigned> {};

TEST_P(RandomStages, ComputeWhatTheFunctionsDo) {
  const Mechanism mechanism = make_mechanism(testing::random_tree(GetParam(), 5));
  const Fusion fusion = optimised(mechanism, kFused);
  const Stages stages = stages_of(fusion);
  const std::uint64_t seed = GetParam();
  const std::vector<Residue> configuration = values_with(stages.configuration.make, seed);
  const std::vector<Residue> motion = values_with(stages.motion.make, seed, configuration);
  EXPECT_EQ(configuration.size(), stages.configuration.fields.size());
  EXPECT_EQ(motion.size(), stages.motion.fields.size());
  ASSERT_EQ(stages.configuration.members.size(), 3u);
  ASSERT_EQ(stages.motion.members.size(), 4u);
  for (std::size_t k = 0; k < kFused.size(); ++k) {
    const bool at_rest = k < 3;
    const Function& member = at_rest ? stages.configuration.members[k] : stages.motion.members[k - 3];
    const std::vector<Residue> expected = values_with(derive_function(mechanism, kFused[k]), seed);
    EXPECT_EQ(member.name, kFused[k]);
    EXPECT_TRUE(values_with(member, seed, at_rest ? configuration : motion) == expected) << member.name;
    EXPECT_TRUE(values_with(function_of(fusion, k), seed) == expected) << member.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomStages, ::testing::Range(1u, 9u));

int operations(const Function& function) { return count_operations(function).arithmetic(); }

int operations(const Stages& stages) {
  int total = 0;
  for (const Stage* stage : {&stages.configuration, &stages.motion}) {
    total += operations(stage->make);
    for (const Function& member : stage->members) total += operations(member);
  }
  return total;
}

// The steps of a member depend on inputs that no stage has (accelerations, torques); all other steps belong to the
// stages.
TEST(Stages, ComputeNothingTwice) {
  const Fusion fusion =
      optimised(make_mechanism(testing::random_tree(3, 6)), {"inertia_matrix", "gravity", "coriolis_matrix", "bias"});
  EXPECT_EQ(operations(stages_of(fusion)), operations(fusion.function));
}

TEST(Stages, CostLessThanTheFunctionsByThemselves) {
  const Fusion fusion = optimised(make_mechanism(testing::random_tree(3, 6)), kFused);
  int alone = 0;
  for (std::size_t k = 0; k < kFused.size(); ++k) alone += operations(function_of(fusion, k));
  EXPECT_LT(operations(stages_of(fusion)), alone);
}

// A member of the configuration reads neither positions nor sines: they are stored if it needs them.
TEST(Stages, ReadNoArgumentOfAnEarlierStage) {
  const Stages stages = stages_of(optimised(make_mechanism(testing::random_tree(5, 5)), kFused));
  for (const Stage* stage : {&stages.configuration, &stages.motion}) {
    for (const Function& member : stage->members) {
      for (const Input& input : inputs_read(member)) {
        EXPECT_NE(input.kind, InputKind::q) << member.name;
        EXPECT_NE(input.kind, InputKind::qd) << member.name;
      }
    }
  }
  for (const Input& input : inputs_read(stages.motion.make)) EXPECT_NE(input.kind, InputKind::q);
}

TEST(Stages, WithoutVelocitiesAreOne) {
  const Stages stages = stages_of(optimised(make_mechanism(testing::random_tree(2, 4)), {"inertia_matrix", "gravity"}));
  EXPECT_EQ(stages.configuration.members.size(), 2u);
  EXPECT_TRUE(stages.motion.members.empty());
}

}  // namespace
}  // namespace flatdyn
