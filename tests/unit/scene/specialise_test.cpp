// SPDX-License-Identifier: GPL-2.0-or-later
#include "functions/scene/specialise.hpp"

#include <gtest/gtest.h>

#include "functions/exact_proof.hpp"
#include "functions/function_table.hpp"
#include "functions/planning/formulations.hpp"
#include "graph/count.hpp"
#include "graph/well_formed.hpp"
#include "support/robots.hpp"
#include "support/spare_joints.hpp"

namespace flatdyn {
namespace {

class Specialise : public ::testing::Test {
 protected:
  static SceneOutputs outputs(const std::string& function, const std::vector<std::string>& entries) {
    SceneOutputs result{{function, {"scene.toml", 3}}, {}};
    for (const std::string& entry : entries) result.entries.push_back({entry, {"scene.toml", 4}});
    return result;
  }

  const Mechanism mechanism = testing::with_spare_joints(make_mechanism(testing::random_tree(5, 4, true)));
  Diagnostics found;
};

TEST_F(Specialise, EveryFunctionAtRestIsWhatTheLagrangianSaysThere) {
  for (const FunctionRow& entry : function_table()) {
    if (!entry.applies_to(mechanism) || entry.traits.leaves_rest) continue;
    const Function still = at_rest(derive_function(mechanism, entry.name));
    EXPECT_FALSE(check_well_formed(still)) << entry.name;
    EXPECT_TRUE(prove_exactly(mechanism, still).equal) << entry.name;
  }
}

// A function at rest is compared with the Lagrangian at rest, so one that still reads velocities is detected.
TEST_F(Specialise, AFunctionThatReadsVelocitiesIsNotAtRest) {
  Function moving = derive_function(mechanism, "inverse_dynamics");
  EXPECT_TRUE(prove_exactly(mechanism, moving).equal);
  moving.at_rest = true;
  EXPECT_FALSE(prove_exactly(mechanism, moving).equal);
}

TEST_F(Specialise, AFunctionWithoutVelocitiesStaysAsItIs) {
  const Function gravity = derive_function(mechanism, "gravity");
  EXPECT_FALSE(at_rest(gravity).at_rest);
  EXPECT_EQ(count_operations(at_rest(gravity)), count_operations(gravity));
}

TEST_F(Specialise, SingleAccelerationsAreProvenToo) {
  const Function whole = derive_function(mechanism, "forward_dynamics");
  Function part = with_outputs(whole, mechanism, outputs("forward_dynamics", {"qdd[1]"}), found);
  const ExactResult right = prove_exactly(mechanism, part);
  EXPECT_TRUE(right.equal);
  EXPECT_EQ(right.entries, 1);
  EXPECT_GT(right.degree_bound, prove_exactly(mechanism, whole).degree_bound);
  NodeId& entry = part.outputs[0].entries[1];
  entry = part.graph.scaled(2, entry);
  EXPECT_FALSE(prove_exactly(mechanism, part).equal);
}

TEST_F(Specialise, WhatIsLeftOutIsNotCompared) {
  const Function part = with_outputs(derive_function(mechanism, "inertia_matrix"), mechanism,
                                     outputs("inertia_matrix", {"B[0][0]", "B[1]"}), found);
  EXPECT_FALSE(check_well_formed(part));
  const ExactResult result = prove_exactly(mechanism, part);
  EXPECT_TRUE(result.equal);
  EXPECT_EQ(result.entries, 1 + mechanism.size());
}

TEST_F(Specialise, AllEntriesAreTheFunctionItself) {
  const Function whole = derive_function(mechanism, "gravity");
  EXPECT_TRUE(is_whole(with_outputs(whole, mechanism, outputs("gravity", {"g"}), found)));
}

TEST_F(Specialise, WhatIsWrongIsSaidWithItsPlace) {
  with_outputs(derive_function(mechanism, "gravity"), mechanism, outputs("gravity", {"g[9]", "h"}), found);
  ASSERT_EQ(found.all().size(), 2U);
  EXPECT_EQ(found.all()[0].place, (Place{"scene.toml", 4}));
  EXPECT_FALSE(found.only_unsupported());
}

TEST_F(Specialise, ABaseRegressorIsAWhole) {
  with_outputs(derive_function(mechanism, "base_regressor"), mechanism, outputs("base_regressor", {"Y_b[0]"}), found);
  EXPECT_TRUE(found.only_unsupported());
}

}  // namespace
}  // namespace flatdyn
