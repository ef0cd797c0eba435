// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/places_in_file.hpp"

#include <gmock/gmock.h>

#include "unit/input/robot_file.hpp"

namespace flatdyn {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class PlacesInFile : public RobotFiles {};

TEST_F(PlacesInFile, AreThoseOfClassesWhereTheseGiveNumbers) {
  const std::string text = describe_places(read("r.xml", R"(<mujoco>
  <default><default class="hip">
    <joint damping="2" armature=".1" range="-10 20"/>
  </default></default>
  <worldbody>
    <body name="leg">
      <joint name="j" class="hip" frictionloss="3"/>
      <inertial pos="0 0 0" mass="2" diaginertia="1 1 1"/>
    </body>
  </worldbody>
</mujoco>)"));
  const std::string file = (folder_ / "r.xml").string();
  EXPECT_THAT(text, HasSubstr("joint " + file + ":7; viscous friction " + file + ":3; Coulomb friction " + file +
                              ":7; armature, lower limit, upper limit " + file + ":3"));
  EXPECT_THAT(text, HasSubstr("inertia, mass " + file + ":8"));
  EXPECT_THAT(text, Not(HasSubstr("stiffness")));
}

}  // namespace
}  // namespace flatdyn
