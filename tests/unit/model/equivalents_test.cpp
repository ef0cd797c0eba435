// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/equivalents.hpp"

#include <gtest/gtest.h>

#include "functions/exact_proof.hpp"
#include "functions/planning/formulations.hpp"
#include "support/robot_models.hpp"

namespace flatdyn {
namespace {

// The poses of links determine where the frames are.
TEST(RaisedFrames, LeaveLinksWhereTheyAre) {
  const Mechanism arm = testing::model_of("panda.urdf").mechanism;
  const Mechanism raised = with_frame_shifted(with_frame_shifted(arm, 2, Number(1) / 3), 6, Number(-2) / 7);
  EXPECT_FALSE(vanishes(raised.bodies[2].p[1] - arm.bodies[2].p[1]));
  for (const char* name : {"forward_kinematics", "jacobian", "forward_kinematics:panda_link3", "inverse_dynamics"}) {
    EXPECT_TRUE(prove_exactly(arm, derive_function(raised, name)).equal) << name;
  }
}

TEST(RaisedFrames, AreThoseOfRevoluteJoints) {
  const Mechanism scara = testing::model_of("scara.toml").mechanism;
  for (int i = 0; i < scara.size(); ++i) {
    if (scara.bodies[static_cast<std::size_t>(i)].prismatic) {
      EXPECT_THROW(with_frame_shifted(scara, i, 1), Failure);
    }
  }
  EXPECT_TRUE(scara.has_prismatic_joint());
}

TEST(LengthUnit, MakesThatLengthOne) {
  const Mechanism arm = testing::model_of("ur5.urdf").mechanism;
  const Number length = GiNaC::abs(arm.bodies[2].p[0]);
  const Mechanism scaled = in_length_unit(arm, length);
  EXPECT_TRUE(vanishes(GiNaC::abs(scaled.bodies[2].p[0]) - 1));
  for (const char* name : {"inverse_dynamics", "inertia_matrix", "potential_energy", "forward_dynamics"}) {
    EXPECT_TRUE(prove_exactly(arm, derive_function(scaled, name)).equal) << name;
  }
}

}  // namespace
}  // namespace flatdyn
