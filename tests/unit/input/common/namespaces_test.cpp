// SPDX-License-Identifier: GPL-2.0-or-later
// Prefixes of XML mean what their addresses say.
#include <gmock/gmock.h>

#include "unit/input/robot_file.hpp"
#include "unit/input/sdf/sdf_text.hpp"

namespace flatdyn {
namespace {

using ::testing::HasSubstr;

class Namespaces : public RobotFiles {
 protected:
  // The same file with Drake's words under another prefix, as Python's ElementTree saves it.
  static std::string under(const std::string& prefix, std::string text, const std::string& address) {
    for (std::size_t k = text.find("drake:"); k != std::string::npos; k = text.find("drake:", k + prefix.size())) {
      text.replace(k, std::string_view("drake").size(), prefix);
    }
    const std::size_t end = text.find('>');
    return text.insert(end, " xmlns:" + prefix + "=\"" + address + "\"");
  }
};

const std::string kDrakesWords =
    one_joint_urdf("revolute", R"(<limit lower="-1" upper="1" effort="5" velocity="2" drake:acceleration="15"/>)",
                   R"(<transmission name="t"><joint name="j"/><actuator name="m"><drake:rotor_inertia value="0.02"/>
       <drake:gear_ratio value="10"/></actuator></transmission>)");

TEST_F(Namespaces, AreKnownByTheirAddresses) {
  for (const char* address : {"http://drake.mit.edu", "https://drake.mit.edu/"}) {
    for (const char* prefix : {"drake", "ns0", "d"}) {
      const Joint joint = read("r.urdf", under(prefix, kDrakesWords, address)).joints.at(0);
      ASSERT_TRUE(joint.limits.acceleration.has_value()) << prefix;
      EXPECT_EQ(joint.limits.acceleration->number, 15);
      EXPECT_EQ(joint.armature.number, 2);
    }
  }
}

TEST_F(Namespaces, OfOthersAreNotDrakes) {
  Diagnostics diagnostics;
  const std::string text =
      one_joint_urdf("revolute", R"(<limit lower="-1" upper="1" effort="5" velocity="2" drake:acceleration="15"/>)");
  const std::string other = under("ns0", text, "http://example.com/other");
  EXPECT_FALSE(read_robot(write("r.urdf", other), {}, diagnostics).has_value());
  EXPECT_THAT(to_string(diagnostics.all().at(0)), HasSubstr("r.urdf:1: error: joint \"j\", limit: unknown attribute"));
}

TEST_F(Namespaces, OfTheOutermostElementAreNoPrefixes) {
  const Robot robot =
      read("r.urdf",
           "<ns0:robot xmlns:ns0=\"http://www.ros.org\" name=\"r\"><ns0:link name=\"base\"/>"
           "<ns0:link name=\"arm\"><ns0:inertial><ns0:mass value=\"2\"/><ns0:inertia ixx=\"1\" iyy=\"1\" "
           "izz=\"1\"/></ns0:inertial></ns0:link><ns0:joint name=\"j\" type=\"continuous\"><ns0:parent "
           "link=\"base\"/><ns0:child link=\"arm\"/></ns0:joint></ns0:robot>");
  EXPECT_EQ(robot.links.size(), 2U);
  EXPECT_EQ(robot.links[1].inertials.at(0).mass.number, 2);
}

TEST_F(Namespaces, AreThoseOfSdfToo) {
  const std::string body = "<inertial><mass>1</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia></inertial>";
  std::string text =
      sdf_model("<link name=\"base\">" + body + "</link><link name=\"arm\">" + body + "</link>" +
                "<joint name=\"fix\" type=\"fixed\"><parent>world</parent><child>base</child></joint>" +
                sdf_joint("revolute",
                          "<axis><xyz>0 0 1</xyz><limit><drake:acceleration>15</drake:acceleration></limit></axis>"
                          "<drake:rotor_inertia>0.02</drake:rotor_inertia><drake:gear_ratio>10</drake:gear_ratio>"));
  const Joint joint = read("r.sdf", under("ns0", text, "http://drake.mit.edu")).joints.back();
  ASSERT_TRUE(joint.limits.acceleration.has_value());
  EXPECT_EQ(joint.limits.acceleration->number, 15);
  EXPECT_EQ(joint.armature.number, 2);
}

TEST_F(Namespaces, OfXacroAreATemplate) {
  Diagnostics diagnostics;
  const std::string text =
      "<robot name=\"r\" xmlns:ns0=\"http://www.ros.org/wiki/xacro\">\n"
      "<ns0:property name=\"m\" value=\"2\"/><link name=\"base\"/></robot>";
  EXPECT_FALSE(read_robot(write("r.urdf", text), {}, diagnostics).has_value());
  EXPECT_THAT(to_string(diagnostics.all().at(0)), HasSubstr("r.urdf:2: error: <xacro:property>: this is a xacro"));
}

}  // namespace
}  // namespace flatdyn
