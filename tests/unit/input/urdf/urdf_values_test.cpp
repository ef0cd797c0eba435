// SPDX-License-Identifier: GPL-2.0-or-later
// Values of URDF files in forms that are valid and not the usual ones: limits that stand for none, bodies without
// inertia, rotations by quaternions, other encodings.
#include <gmock/gmock.h>

#include <cmath>

#include "robot/model/mechanism.hpp"
#include "robot/model/states.hpp"
#include "unit/input/robot_file.hpp"

namespace flatdyn {
namespace {

using ::testing::HasSubstr;

class UrdfValuesRead : public RobotFiles {
 protected:
  Joint joint(const std::string& type, const std::string& elements) {
    return read("r.urdf", one_joint_urdf(type, elements)).joints.at(0);
  }
  std::string messages() const {
    std::string all;
    for (const Diagnostic& each : diagnostics_.all()) all += to_string(each) + "\n";
    return all;
  }
};

TEST_F(UrdfValuesRead, LimitsThatNoJointReachesAreNone) {
  for (const std::string type : {"revolute", "prismatic"}) {
    const Joint j = joint(type, R"(<limit lower="-1e16" upper="1e16" velocity="1e16" effort="1e16"/>)");
    EXPECT_FALSE(j.limits.lower || j.limits.upper || j.limits.velocity || j.limits.effort);
    ASSERT_EQ(diagnostics_.all().size(), 1U);
    EXPECT_THAT(messages(), HasSubstr("are taken as not given: lower, upper, velocity, effort"));
  }
  const Joint j = joint("prismatic", R"(<limit lower="-1e4" upper="10001" velocity="1e6" effort="1000001"/>)");
  EXPECT_TRUE(j.limits.lower && j.limits.velocity);
  EXPECT_FALSE(j.limits.upper || j.limits.effort);
}

TEST_F(UrdfValuesRead, LimitsFromOneToZeroAreNone) {
  const Joint j = joint("revolute", R"(<limit lower="1" upper="0" velocity="1" effort="1"/>)");
  EXPECT_FALSE(j.limits.lower || j.limits.upper);
  EXPECT_THAT(messages(), HasSubstr("note: joint \"j\": limits from 1 to 0, Bullet's word for none"));
}

TEST_F(UrdfValuesRead, StatesAreDrawnOnTheRightSideOfOneLimit) {
  const Mechanism mechanism =
      make_mechanism(read("r.urdf", one_joint_urdf("revolute", R"(<limit lower="9" upper="1e16"/>)")));
  for (const State& state : random_states(mechanism, 20, 1)) EXPECT_TRUE(state.q[0] >= 9 && state.q[0] < 16);
}

TEST_F(UrdfValuesRead, ABodyWithoutInertiaIsAPointMass) {
  const std::string body = R"(<inertial><origin xyz="0 0 1"/><mass value="2"/></inertial>)";
  const Robot robot =
      read("r.urdf", "<robot name=\"r\"><link name=\"base\">" + body + "</link><link name=\"arm\">" + body +
                         R"(</link><joint name="j" type="revolute"><parent link="base"/>
      <child link="arm"/></joint></robot>)");
  EXPECT_TRUE(robot.links.at(1).inertials.at(0).mass.number.is_equal(2));
  EXPECT_TRUE(robot.links.at(1).inertials.at(0).tensor[0][0].is_zero());
  ASSERT_EQ(diagnostics_.all().size(), 2U);
  EXPECT_EQ(diagnostics_.all()[0].severity, Severity::note);
  EXPECT_THAT(diagnostics_.all()[0].message, HasSubstr("it counts as a point mass, and does not move"));
  EXPECT_EQ(diagnostics_.all()[1].severity, Severity::warning);
}

TEST_F(UrdfValuesRead, AQuaternionIsARotation) {
  using Step = Displacement::Kind;
  const auto turn = [this](const std::string& origin) { return joint("revolute", origin).origin.displacements; };
  const auto quarter = turn(R"(<origin quat_xyzw="0 0 0.7071067811865476 0.7071067811865476"/>)");
  ASSERT_EQ(quarter.size(), 1U);
  EXPECT_EQ(quarter[0].kind, Step::rotation_z);
  EXPECT_TRUE(quarter[0].angle.is_equal(GiNaC::Pi / 2));
  EXPECT_TRUE(turn(R"(<origin quat_xyzw="0 0 0 1"/>)").empty());
  // A quarter turn of pitch, where roll and yaw are about one axis.
  const auto pitch = turn(R"(<origin quat_xyzw="0.27059805 0.65328148 -0.27059805 0.65328148"/>)");
  EXPECT_EQ(pitch.size(), 2U);
  for (const Displacement& each : pitch) EXPECT_TRUE(is_rational(each.angle * 12 / GiNaC::Pi));
}

// A general rotation, against the matrix that the quaternion gives.
TEST_F(UrdfValuesRead, AQuaternionKeepsItsDigits) {
  const auto d = joint("revolute", R"(<origin quat_xyzw="0.1 -0.7 0.5 0.5"/>)").origin.displacements;
  ASSERT_EQ(d.size(), 3U);
  const double yaw = nearest_double(d[0].angle), pitch = nearest_double(d[1].angle), roll = nearest_double(d[2].angle);
  EXPECT_NEAR(std::cos(yaw) * std::cos(pitch), 0.01 + 0.25 - 0.49 - 0.25, 1e-15);
  EXPECT_NEAR(-std::sin(pitch), 2 * (0.1 * 0.5 + 0.7 * 0.5), 1e-15);
  EXPECT_NEAR(std::cos(pitch) * std::sin(roll), 2 * (0.5 * 0.1 - 0.7 * 0.5), 1e-15);
  EXPECT_NEAR(std::sin(yaw) * std::cos(pitch), 2 * (0.5 * 0.5 - 0.1 * 0.7), 1e-15);
}

TEST_F(UrdfValuesRead, AQuaternionIsExactToManyDigits) {
  const auto d = joint("revolute", R"(<origin quat_xyzw="0 0 0.6 0.8"/>)").origin.displacements;
  ASSERT_EQ(d.size(), 1U);
  EXPECT_EQ(to_decimal(d[0].angle, 60), to_decimal(2 * GiNaC::atan(Number(3) / 4), 60));
}

TEST_F(UrdfValuesRead, AQuaternionMustAgreeAndHaveUnitLength) {
  EXPECT_EQ(joint("revolute", R"(<origin rpy="0 0 1.5707963" quat_xyzw="0 0 0.7071068 0.7071068"/>)")
                .origin.displacements.size(),
            1U);
  for (const std::string origin :
       {R"(<origin rpy="0 0 1.5" quat_xyzw="0 0 0.7071068 0.7071068"/>)", R"(<origin quat_xyzw="0 0 0 0"/>)",
        R"(<origin quat_xyzw="0 0 1 1"/>)", R"(<origin quat_xyzw="0 0 1"/>)"}) {
    EXPECT_FALSE(read_robot(write("r.urdf", one_joint_urdf("revolute", origin)), {}, diagnostics_).has_value())
        << origin;
  }
}

TEST_F(UrdfValuesRead, ReadsLatin1WhereTheFirstLineSaysSo) {
  const std::string named = R"(<link name="b"/><joint name="gr)"
                            "\xF6"
                            R"(sse" type="fixed"><parent link="arm"/>
      <child link="b"/></joint>)";
  const std::string text = one_joint_urdf("revolute", "", named);
  const Robot robot = read("r.urdf", "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>\n" + text);
  EXPECT_EQ(robot.joints.at(1).name, "gr\xC3\xB6sse");
  EXPECT_THAT(messages(), HasSubstr("the file is ISO 8859-1"));
  EXPECT_FALSE(read_robot(write("r.urdf", text), {}, diagnostics_).has_value());
}

}  // namespace
}  // namespace flatdyn
