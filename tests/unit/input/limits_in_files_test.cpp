// SPDX-License-Identifier: GPL-2.0-or-later
// Limits of position, velocity and effort as the formats' programs write them: those that stand for none, in every
// reader.
#include <gmock/gmock.h>

#include "unit/input/robot_file.hpp"
#include "unit/input/sdf/sdf_text.hpp"

namespace flatdyn {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class LimitsInFiles : public RobotFiles {
 protected:
  std::string messages() const {
    std::string all;
    for (const Diagnostic& each : diagnostics_.all()) all += to_string(each) + "\n";
    return all;
  }

  static std::string sdf_with_limits(const std::string& limit) {
    const std::string body =
        "<inertial><mass>1</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia></inertial>";
    return sdf_model("<link name=\"base\">" + body + "</link><link name=\"arm\">" + body + "</link>" +
                     "<joint name=\"fix\" type=\"fixed\"><parent>world</parent><child>base</child></joint>" +
                     sdf_joint("revolute", "<axis><xyz>0 0 1</xyz><limit>" + limit + "</limit></axis>"));
  }
};

void expect_none(const Robot& robot, const std::string& written) {
  for (const Joint& joint : robot.joints) {
    const Limits& limits = joint.limits;
    EXPECT_FALSE(limits.lower || limits.upper || limits.velocity || limits.effort) << written;
  }
}

// The largest double and float, to the digits that programs print, and words.
const char* const kNone[] = {"1.79769e+308", "1.7976931348623157e308",
                             "1.797693e308", "1e308",
                             "3.40282e+38",  "3.4028234663852886e+38",
                             "3.402823e38",  "1e400",
                             "inf",          "Inf",
                             "infinity",     ".inf",
                             "1E+99999",     "1e30"};

TEST_F(LimitsInFiles, ThatAreNoneInUrdf) {
  for (const std::string none : kNone) {
    const std::string attributes =
        "lower=\"-" + none + "\" upper=\"" + none + "\" velocity=\"" + none + "\" effort=\"" + none + "\"";
    for (const char* type : {"revolute", "prismatic"}) {
      expect_none(read("r.urdf", one_joint_urdf(type, "<limit " + attributes + "/>")), none);
      EXPECT_THAT(messages(), IsEmpty());
    }
  }
}

TEST_F(LimitsInFiles, ThatAreNoneInSdf) {
  for (const std::string none : kNone) {
    const std::string limit = "<lower>-" + none + "</lower><upper>+" + none + "</upper><velocity>" + none +
                              "</velocity><effort>" + none + "</effort>";
    expect_none(read("r.sdf", sdf_with_limits(limit)), none);
    EXPECT_THAT(messages(), IsEmpty());
  }
  expect_none(read("r.sdf", sdf_with_limits("<lower>-1e16</lower><upper>1e+16</upper><velocity>-1</velocity>"
                                            "<effort>-1.79769e+308</effort>")),
              "SDF's defaults");
  EXPECT_THAT(messages(), IsEmpty());
}

TEST_F(LimitsInFiles, ThatAreNoneInMjcf) {
  for (const std::string none : kNone) {
    const std::string range = "\"-" + none + " " + none + "\"";
    for (const char* angle : {"radian", "degree"}) {
      expect_none(read("r.xml", std::string("<mujoco><compiler angle=\"") + angle +
                                    "\"/><worldbody><body><joint name=\"j\" axis=\"0 1 0\" range=" + range +
                                    " actuatorfrcrange=" + range + "/><geom size=\"0.1\" pos=\"0.1 0 0\"/></body>" +
                                    "</worldbody></mujoco>"),
                  none);
      EXPECT_THAT(messages(), IsEmpty()) << none;
    }
  }
}

TEST_F(LimitsInFiles, ThatAreNoneInToml) {
  for (const std::string none : {"1.79769e+308", "1.7976931348623157e308", "1e308", "3.40282e+38", "inf", "1e30",
                                 "\"inf\"", "\"1.79769e+308\"", "340_282_350_000_000_000_000_000_000_000_000_000.0"}) {
    const std::string negative = none[0] == '"' ? "\"-" + none.substr(1) : "-" + none;
    for (const char* units : {"", "angles = \"deg\"\n"}) {
      expect_none(
          read("r.toml", units + ("[[link]]\nmass = 1\ncom = [1, 0, 0]\nlimits = { lower = " + negative +
                                  ", upper = " + none + ", velocity = " + none + ", effort = " + none + " }\n")),
          none);
      EXPECT_THAT(messages(), IsEmpty()) << none;
    }
  }
}

TEST_F(LimitsInFiles, OfNothingReadableAreNotCalledZero) {
  std::ignore = read_robot(write("r.sdf", sdf_with_limits("<lower>a</lower><upper>b</upper>")), {}, diagnostics_);
  EXPECT_THAT(messages(), HasSubstr("\"a\" is not a number"));
  EXPECT_THAT(messages(), Not(HasSubstr("limits of 0")));
}

TEST_F(LimitsInFiles, WhoseLowerIsAboveTheUpperAreNoneInUrdfAndSdf) {
  const Robot urdf =
      read("r.urdf", one_joint_urdf("prismatic", R"(<limit lower="1" upper="-1" velocity="1" effort="9"/>)"));
  EXPECT_FALSE(urdf.joints[0].limits.lower || urdf.joints[0].limits.upper);
  EXPECT_TRUE(urdf.joints[0].limits.velocity && urdf.joints[0].limits.effort);
  EXPECT_THAT(messages(), HasSubstr("no limit in Bullet and ODE"));
  const Robot sdf = read("r.sdf", sdf_with_limits("<lower>1</lower><upper>-1</upper>"));
  EXPECT_FALSE(sdf.joints.back().limits.lower || sdf.joints.back().limits.upper);
  EXPECT_THAT(messages(), HasSubstr("no limit in Bullet and ODE"));
}

}  // namespace
}  // namespace flatdyn
