// SPDX-License-Identifier: GPL-2.0-or-later
// Residues: numbers of 1e-60 where rational rotations leave no exact zero. Nothing is divided by them.
#include <gtest/gtest.h>

#include <cmath>

#include "code/emit/narrowed.hpp"
#include "functions/planning/make_functions.hpp"
#include "support/written_model.hpp"

namespace flatdyn {
namespace {

// The last axis is perpendicular to the first one, which no rational angles between them and the slide can say.
LoadedRobot arm_with_an_oblique_slide() {
  return testing::model_of_toml(R"(
[[link]]
rpy = [0.7, 0, 0]
mass = 0.05
com = [0.3, 0, 0]
inertia = { xx = 5e-5, yy = 5e-5, zz = 5e-5 }
inertia_about = "com"
[[link]]
xyz = [0.4, 0, 0]
rpy = ["-pi/2", 0, 0]
type = "prismatic"
axis = [0, 0.6, 0.8]
mass = 0.001
com = [0.1, 0, 0]
inertia = { xx = 1e-6, yy = 1e-6, zz = 1e-6 }
inertia_about = "com"
[[link]]
xyz = [0.5, 0, 0]
rpy = [0, 0.4, 0]
mass = 2.3
com = [0.3, 0.1, 0]
inertia = { xx = 0.0023, yy = 0.0023, zz = 0.0023 }
inertia_about = "com"
[tip]
xyz = [0.3, 0.1, 0.05]
)");
}

TEST(Residues, MakeNoConstantInfiniteInFloat) {
  PipelineOptions options;
  options.functions = {"forward_dynamics", "operational_bias", "operational_inertia", "coriolis_matrix"};
  Progress quiet(true);
  Diagnostics none;
  const std::vector<NarrowedConstant> constants =
      narrowed_constants(functions_of(make_functions(arm_with_an_oblique_slide(), options, quiet, none)));
  ASSERT_FALSE(constants.empty());
  EXPECT_EQ(constants.front().becomes, 0.0F) << constants.front().value << " " << constants.front().function;
}

}  // namespace
}  // namespace flatdyn
