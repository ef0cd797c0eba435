// SPDX-License-Identifier: GPL-2.0-or-later
#include "functions/planning/search.hpp"

#include <gtest/gtest.h>

#include <chrono>

#include "functions/exact_proof.hpp"
#include "functions/planning/formulations.hpp"
#include "graph/passes/draft.hpp"
#include "graph/passes/passes.hpp"
#include "support/robot_models.hpp"
#include "support/robots.hpp"

namespace flatdyn {
namespace {

constexpr const char* kSearched[] = {
    "inverse_dynamics", "inertia_matrix", "coriolis_matrix", "forward_dynamics",
    "potential_energy", "kinetic_energy", "gravity",         "inverse_dynamics_tip_force"};

// A random robot; those of odd seeds have no prismatic joints, so lengths are free, too.
Robot random_robot(unsigned seed) {
  Robot robot = testing::random_tree(seed, 5);
  for (Joint& joint : robot.joints) {
    if (seed % 2 == 1 && joint.type == JointType::prismatic) joint.type = JointType::revolute;
  }
  return robot;
}

// After every kind of move, applied one after the other, the function is still the Lagrangian's.
class RandomChoices : public ::testing::TestWithParam<unsigned> {};

TEST_P(RandomChoices, GiveTheSameFunctions) {
  const Mechanism mechanism = make_mechanism(random_robot(GetParam()));
  testing::Numbers random(GetParam());
  Choices choices = uniform_choices(mechanism, Grouping::i_yy);
  for (int k = 0; k < 12; ++k) {
    const std::vector<Move> moves = possible_moves(mechanism, choices);
    moves[static_cast<std::size_t>(random.integer(0, static_cast<int>(moves.size()) - 1))](choices);
    const char* name = kSearched[static_cast<std::size_t>(k) % std::size(kSearched)];
    for (FormulationIndex way = 0; way < kFormulationCount; ++way) {
      const std::optional<Function> function = formulation(mechanism, name, way, choices);
      if (!function) continue;
      const ExactResult result = prove_exactly(mechanism, *function);
      EXPECT_TRUE(result.equal) << name << " after " << k << " moves: " << result.summary();
    }
  }
}

TEST_P(RandomChoices, StillFramesGiveTheSameFunctions) {
  const Mechanism mechanism = make_mechanism(random_robot(GetParam()));
  for (const Grouping grouping : kGroupings) {
    const Choices choices = with_still_frames(mechanism, uniform_choices(mechanism, grouping), StillFrames::all);
    for (const char* name : kSearched) {
      const std::optional<Function> function = formulation(mechanism, name, 0, choices);
      EXPECT_TRUE(prove_exactly(mechanism, function.value()).equal) << name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomChoices, ::testing::Range(1u, 7u));

// Inverse dynamics of one robot after a search.
struct Searched {
  explicit Searched(const char* robot) : mechanism(testing::model_of(robot).mechanism) {}

  Function made(const Choices& choices) const {
    return run_passes(formulation(mechanism, "inverse_dynamics", 0, choices).value());
  }

  ChoiceSearch search() const {
    const Choices start = uniform_choices(mechanism, Grouping::i_yy);
    return ChoiceSearch(mechanism, start, made(start), true, [this](const Choices& c) { return made(c); });
  }

  Mechanism mechanism;
};

TEST(ChoiceSearch, MoreCandidatesAreNeverWorseAndTheSameNumberIsTheSameResult) {
  const Searched robot("planar_2r_example_7_2.toml");
  ChoiceSearch once = robot.search(), again = robot.search();
  int last = cost(robot.made(once.best()));
  for (int k = 0; k < 40; ++k) {
    once.step();
    again.step();
    const Function function = robot.made(once.best()), same = robot.made(again.best());
    EXPECT_LE(cost(function), last);
    last = cost(function);
    ASSERT_EQ(function.graph.size(), same.graph.size());
    for (NodeId id = 0; id < function.graph.size(); ++id) ASSERT_TRUE(function.graph[id] == same.graph[id]);
  }
}

TEST(ChoiceSearch, FindsCheaperChoices) {
  const Searched robot("ur5.urdf");
  std::vector<ChoiceSearch> searches = {robot.search()};
  const int before = cost(robot.made(searches[0].best()));
  EXPECT_EQ(run_searches(searches, {25, std::nullopt}), 25);
  const Function after = robot.made(searches[0].best());
  EXPECT_LT(cost(after), before - 10);
  EXPECT_TRUE(prove_exactly(robot.mechanism, after).equal);
}

TEST(ChoiceSearch, ATimeEndsIt) {
  const Searched robot("ur5.urdf");
  std::vector<ChoiceSearch> searches = {robot.search(), robot.search()};
  const auto start = std::chrono::steady_clock::now();
  const int candidates = run_searches(searches, {std::nullopt, 0.5});
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  EXPECT_GE(seconds, 0.5);
  EXPECT_LT(seconds, 20);
  std::vector<ChoiceSearch> counted = {robot.search(), robot.search()};
  EXPECT_EQ(run_searches(counted, {candidates, std::nullopt}), candidates);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(cost(robot.made(searches[k].best())), cost(robot.made(counted[k].best())));
  }
}

TEST(PossibleMoves, LengthsStayInMetresWhereAJointSlides) {
  const Mechanism mechanism = testing::model_of("scara.toml").mechanism;
  Choices choices = uniform_choices(mechanism, Grouping::i_yy);
  for (const Move& move : possible_moves(mechanism, choices)) move(choices);
  EXPECT_TRUE(choices.length_unit.is_equal(1));
}

}  // namespace
}  // namespace flatdyn
