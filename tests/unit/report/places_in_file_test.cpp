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
  const std::string own = file + ":7 <joint name=\"j\">", of_class = file + ":3 <joint> of class \"hip\"";
  EXPECT_THAT(text, HasSubstr("joint " + own + "; viscous friction " + of_class + "; Coulomb friction " + own +
                              "; armature, lower limit, upper limit " + of_class));
  EXPECT_THAT(text, HasSubstr("inertia, mass " + file + ":8 <inertial>"));
  EXPECT_THAT(text, Not(HasSubstr("stiffness")));
}

TEST_F(PlacesInFile, TellElementsOfOneLineApart) {
  const Robot robot = read("r.xml", R"(<mujoco><default><joint armature=".2"/><geom density="7"/></default><worldbody>
<body><joint name="a"/><geom size="1"/><body><joint name="b" damping="3"/><geom size="1" mass="2"/></body></body>
</worldbody></mujoco>)");
  const nlohmann::json json = places_json(robot);
  const auto place = [&json](const char* part, std::size_t k, const std::string& what) {
    for (const auto& each : json[part][k]["places"]) {
      if (each["what"] == what) return each;
    }
    return nlohmann::json();
  };
  EXPECT_EQ(place("joints", 0, "armature")["class"], "main");
  EXPECT_EQ(place("joints", 0, "armature")["line"], 1);
  EXPECT_EQ(place("joints", 1, "viscous friction")["line"], 2);
  EXPECT_EQ(place("joints", 1, "viscous friction")["element"], "joint");
  EXPECT_EQ(place("links", 0, "mass")["element"], "geom");
  EXPECT_EQ(place("links", 0, "mass")["class"], "main");
  EXPECT_FALSE(place("links", 1, "mass").contains("class"));
}

}  // namespace
}  // namespace flatdyn
