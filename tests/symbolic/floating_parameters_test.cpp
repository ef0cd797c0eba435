// SPDX-License-Identifier: GPL-2.0-or-later
// Base parameters of robots with a floating base, against exact elimination of the regressor at random states.
#include <gtest/gtest.h>

#include <algorithm>

#include "derivation/parameters/base_parameters.hpp"
#include "support/robot_models.hpp"
#include "truth/definition/sampled_base.hpp"

namespace flatdyn {
namespace {

Mechanism floating(const char* file) {
  LoadOptions options;
  options.read.floating_base = true;
  return load_robot(std::filesystem::path(FLATDYN_SOURCE_DIR) / "robots" / file, options).mechanism;
}

// A base that moves freely identifies all ten of its own, and each joint after it as many as one in general position:
// seven of a revolute joint, four of a prismatic one.
TEST(FloatingParameters, AreTheTenOfTheBaseAndThoseOfJointsInGeneralPosition) {
  const Mechanism quadruped = floating("quadruped12.urdf");
  const BaseParameters base = base_parameters(quadruped, ParameterSet::inertial);
  EXPECT_EQ(base.size(), 10 + 7 * 12);
  for (int k = 0; k < kInertialPerBody; ++k) {
    EXPECT_EQ(base.columns[static_cast<std::size_t>(k)],
              index_of(quadruped.base_bodies() - 1, static_cast<Parameter>(k)));
  }
  EXPECT_EQ(parameter_name(base.columns[1], quadruped.base_bodies()), "m0lx");
  EXPECT_EQ(parameter_indices(quadruped).size(), 10U + 13U * 12U);
  EXPECT_EQ(base_parameters(floating("prismatic_revolute.toml"), ParameterSet::inertial).size(), 10 + 4 + 7);
}

TEST(FloatingParameters, AreWhatEliminationFinds) {
  for (const char* file : {"quadruped12.urdf", "prismatic_revolute.toml", "scara.toml"}) {
    const Mechanism mechanism = floating(file);
    for (const ParameterSet set : {ParameterSet::inertial, ParameterSet::given, ParameterSet::full}) {
      EXPECT_TRUE(compare_with_samples(mechanism, base_parameters(mechanism, set), set).equal) << file;
    }
  }
}

}  // namespace
}  // namespace flatdyn
