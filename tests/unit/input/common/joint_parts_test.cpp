// SPDX-License-Identifier: GPL-2.0-or-later
// Joints of several degrees of freedom, which are read as joints of one each: the same robot in several formats is the
// same mechanism, exactly.
#include <gmock/gmock.h>

#include "robot/input/mjcf/orientation.hpp"
#include "robot/model/mechanism.hpp"
#include "unit/input/robot_file.hpp"
#include "unit/input/sdf/sdf_text.hpp"

namespace flatdyn {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class JointParts : public RobotFiles {
 protected:
  std::string first_error(const std::string& name, const std::string& text) {
    diagnostics_ = {};
    read_robot(write(name, text), {}, diagnostics_);
    for (const Diagnostic& found : diagnostics_.all()) {
      if (found.severity == Severity::error) return found.message;
    }
    return "";
  }
};

// All numbers of the bodies: where they are, what they weigh, how they turn.
std::vector<Number> numbers_of(const Robot& robot) {
  const Mechanism mechanism = make_mechanism(robot);
  std::vector<Number> all;
  for (const Body& body : mechanism.bodies) {
    all.push_back(body.prismatic ? 1 : 0);
    for (const PlanarRotation& turn : {body.beta, body.alpha, body.theta}) all.insert(all.end(), {turn.c, turn.s});
    all.insert(all.end(), body.p.begin(), body.p.end());
    all.push_back(body.inertia.mass);
    for (const Number& each : body.inertia.first_moment) all.push_back(each);
    for (const Vec3& row : body.inertia.inertia) all.insert(all.end(), row.begin(), row.end());
    all.insert(all.end(), {body.viscous, body.coulomb, body.armature});
  }
  for (const auto& row : mechanism.coupling) all.insert(all.end(), row.begin(), row.end());
  return all;
}

void expect_same(const Robot& a, const Robot& b) {
  const std::vector<Number> first = numbers_of(a), second = numbers_of(b);
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t k = 0; k < first.size(); ++k) {
    EXPECT_TRUE(vanishes(Number(first[k] - second[k]).expand())) << k << ": " << first[k] << ", " << second[k];
  }
}

std::vector<std::string> joint_names_of(const Robot& robot) {
  std::vector<std::string> names;
  for (const Joint& joint : robot.joints) names.push_back(joint.name);
  return names;
}

constexpr const char* kArm = R"(
mass = 2
com = [0.1, 0.2, 0.3]
inertia = { xx = 1, yy = 1.5, zz = 2 }
inertia_about = "com"
)";

std::string toml_joint(const std::string& type, const std::string& keys) {
  return "[[link]]\nname = \"arm\"\njoint = \"j\"\ntype = \"" + type + "\"\nxyz = [0.5, 0, 0.25]\n" + keys + kArm;
}

std::string urdf_joint(const std::string& type, const std::string& axis) {
  return R"(<robot name="r"><link name="base"/><link name="arm"><inertial><origin xyz="0.1 0.2 0.3"/><mass value="2"/>
      <inertia ixx="1" iyy="1.5" izz="2" ixy="0" ixz="0" iyz="0"/></inertial></link><joint name="j" type=")" +
         type + R"("><parent link="base"/><child link="arm"/><origin xyz="0.5 0 0.25"/><axis xyz=")" + axis +
         R"("/></joint></robot>)";
}

// A body that moves freely relative to another one.
TEST_F(JointParts, AreSlidesAndABallWhereAJointFloatsInTheTree) {
  std::string urdf = urdf_joint("floating", "0 0 1");
  const std::string base = "<link name=\"base\"/>";
  urdf.replace(urdf.find(base), base.size(),
               "<link name=\"base\"><inertial><mass value=\"1\"/>"
               "<inertia ixx=\"1\" iyy=\"1\" izz=\"1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>");
  const Robot robot = read("r.urdf", urdf);
  EXPECT_THAT(joint_names_of(robot), ElementsAre("j.x", "j.y", "j.z", "j.turn"));
  EXPECT_FALSE(robot.floating_base);
  const std::string slide = "[[link]]\ntype = \"prismatic\"\n";
  const Robot toml = read("r.toml", slide + "axis = [1, 0, 0]\nxyz = [0.5, 0, 0.25]\n" + slide + "axis = [0, 1, 0]\n" +
                                        slide + "[[link]]\ntype = \"spherical\"\n" + kArm);
  expect_same(robot, toml);
}

TEST_F(JointParts, AreTheSamePlanarJointInThreeFormats) {
  const Robot toml = read("r.toml", toml_joint("planar", "viscous = [1, 2, 3]\narmature = [0, 0, 0.5]\n"));
  EXPECT_THAT(joint_names_of(toml), ElementsAre("j.x", "j.y", "j.turn"));
  EXPECT_EQ(toml.links.back().name, "j.between2");
  const Robot mjcf = read("r.xml", R"(<mujoco><worldbody><body name="arm" pos="0.5 0 0.25">
      <joint type="slide" axis="1 0 0" damping="1"/><joint type="slide" axis="0 1 0" damping="2"/>
      <joint axis="0 0 1" damping="3" armature="0.5"/>
      <inertial pos="0.1 0.2 0.3" mass="2" diaginertia="1 1.5 2"/></body></worldbody></mujoco>)");
  expect_same(toml, mjcf);
  const Robot urdf = read("r.urdf", urdf_joint("planar", "0 0 1"));
  EXPECT_THAT(joint_names_of(urdf), ElementsAre("j.x", "j.y", "j.turn"));
  expect_same(urdf, read("r.toml", toml_joint("planar", "")));
}

TEST_F(JointParts, AreLedByNoWholeJoint) {
  std::string urdf = urdf_joint("planar", "0 0 1");
  urdf.insert(urdf.rfind("</robot>"), R"(<link name="hand"/><joint name="k" type="revolute"><parent link="arm"/>
      <child link="hand"/><mimic joint="j"/></joint>)");
  EXPECT_THAT(first_error("r.urdf", urdf), HasSubstr("couplings of a planar joint are not supported"));
  EXPECT_TRUE(diagnostics_.only_unsupported());
}

// x and y of the frame, turned by the smallest angle that takes z to the axis.
TEST_F(JointParts, LieInThePlaneOfTheAxis) {
  const Robot turned = read("r.urdf", urdf_joint("planar", "2 0 0"));
  EXPECT_THAT(diagnostics_.all().front().message, HasSubstr("x and y of its plane"));
  Mat3 R = identity_matrix();
  std::vector<Vec3> axes;
  for (const Joint& joint : turned.joints) {
    R = R * exact_place(joint.origin).R;
    axes.push_back(expanded(R * joint.axis));
    R = R * exact_place(joint.link_offset).R;
  }
  const Mat3 wanted = {Vec3{0, 0, -1}, Vec3{0, 1, 0}, Vec3{1, 0, 0}}, one = identity_matrix();
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_TRUE(vanishes(axes.at(i)[k] - wanted[i][k])) << i << k;
      EXPECT_TRUE(vanishes(Number(R[i][k] - one[i][k]).expand())) << i << k;
    }
  }
  expect_same(turned, read("r.toml", toml_joint("planar", "axis = [3, 0, 0]\n")));
}

std::string sdf_of(const std::string& type, const std::string& elements) {
  return sdf_model(R"(<link name="base"/><link name="arm"><pose>0.5 0 0.25 0 0 0</pose><inertial>
      <pose>0.1 0.2 0.3 0 0 0</pose><mass>2</mass><inertia><ixx>1</ixx><iyy>1.5</iyy><izz>2</izz></inertia></inertial>
      </link>)" + sdf_joint(type, elements));
}

TEST_F(JointParts, AreTheSameUniversalJointAsInSdf) {
  const Robot toml = read("r.toml", toml_joint("universal",
                                               "axis = [1, 0, 0]\naxis2 = [0, 3, 4]\ncoulomb = [1, 2]\n"
                                               "limits = { lower = [-1, -inf], effort = [5, 6] }\n"));
  EXPECT_THAT(joint_names_of(toml), ElementsAre("j.axis", "j.axis2"));
  expect_same(toml,
              read("r.sdf", sdf_of("universal", R"(<axis><xyz>1 0 0</xyz><dynamics><friction>1</friction></dynamics>
      </axis><axis2><xyz>0 3 4</xyz><dynamics><friction>2</friction></dynamics></axis2>)")));
  ASSERT_TRUE(toml.joints[0].limits.lower.has_value());
  EXPECT_TRUE(toml.joints[0].limits.lower->number.is_equal(-1));
  EXPECT_FALSE(toml.joints[1].limits.lower.has_value());
  EXPECT_TRUE(toml.joints[1].limits.effort.value().number.is_equal(6));
}

TEST_F(JointParts, AreTheSameSphericalJointInThreeFormats) {
  const Robot toml = read("r.toml", toml_joint("spherical", "viscous = 0.5\n"));
  EXPECT_EQ(toml.joints[0].type, JointType::spherical);
  const Robot mjcf = read("r.xml", R"(<mujoco><worldbody><body name="arm" pos="0.5 0 0.25">
      <inertial pos="0.1 0.2 0.3" mass="2" diaginertia="1 1.5 2"/><joint name="j" type="ball" damping="0.5"/>
      </body></worldbody></mujoco>)");
  expect_same(toml, mjcf);
  expect_same(read("r.toml", toml_joint("spherical", "")), read("r.sdf", sdf_of("ball", "")));
}

TEST_F(JointParts, AreTheSameScrewAsInSdf) {
  const Robot toml = read("r.toml", toml_joint("screw", "axis = [0, 0, 1]\npitch = 0.125\nviscous = 3\n"));
  EXPECT_THAT(joint_names_of(toml), ElementsAre("j", "j.slide"));
  EXPECT_EQ(make_mechanism(toml).size(), 1);
  expect_same(toml, read("r.sdf", sdf_of("screw", R"(<thread_pitch>-8</thread_pitch><axis><xyz>0 0 1</xyz><dynamics>
      <damping>3</damping></dynamics></axis>)")));
}

TEST_F(JointParts, TurnFirstInACylindricalJoint) {
  const std::string dh =
      "dh = \"standard\"\n[[link]]\nname = \"arm\"\njoint = \"j\"\ntype = \"cylindrical\"\n"
      "d = 0.3\ntheta = \"pi/2\"\na = 1\n";
  const Robot robot = read("r.toml", dh + std::string("limits = { lower = [-1, 0], upper = [2, 0.5] }\n") + kArm);
  EXPECT_THAT(joint_names_of(robot), ElementsAre("j.turn", "j.slide"));
  EXPECT_EQ(robot.joints[1].type, JointType::prismatic);
  EXPECT_TRUE(robot.joints[1].limits.upper.value().number.is_equal(Number(1) / 2));
}

TEST_F(JointParts, AreHeldTogetherOrOneByOne) {
  const std::string chain = toml_joint("planar", "") + "[[link]]\njoint = \"k\"\nmass = 1\ncom = [1, 0, 0]\n";
  EXPECT_EQ(moving_joints(read("r.toml", "fixed = [\"j\"]\n" + chain)).size(), 1U);
  EXPECT_EQ(moving_joints(read("r.toml", "fixed = [\"j.turn\"]\n" + chain)).size(), 3U);
}

TEST_F(JointParts, AreErrorsWhereKeysDoNotFit) {
  const auto toml = [this](const std::string& type, const std::string& keys) {
    return first_error("r.toml", toml_joint(type, keys));
  };
  EXPECT_THAT(toml("planar", "viscous = 2\n"), HasSubstr("link \"arm\", viscous: a list of 3 numbers is expected"));
  EXPECT_THAT(toml("planar", "limits = { lower = [1, 2] }\n"), HasSubstr("limits, lower: a list of 3 numbers"));
  EXPECT_THAT(toml("planar", "axis2 = [1, 0, 0]\n"), HasSubstr("axis2 has no effect"));
  EXPECT_THAT(toml("planar", "axis = [0, 0, 0]\n"), HasSubstr("its axis is zero"));
  EXPECT_THAT(toml("planar", "motor = { inertia = 1 }\n"), HasSubstr("motor: not supported"));
  EXPECT_THAT(toml("universal", ""), HasSubstr("a universal joint needs axis2"));
  EXPECT_THAT(toml("universal", "axis2 = [0, 0, 2]\n"), HasSubstr("its two axes are parallel"));
  EXPECT_THAT(toml("screw", ""), HasSubstr("a screw needs a pitch other than 0"));
  EXPECT_THAT(toml("cylindrical", "pitch = 1\n"), HasSubstr("unknown key \"pitch\""));
  EXPECT_THAT(first_error("r.toml", "dh = \"standard\"\n[[link]]\ntype = \"planar\"\na = 1\n"),
              HasSubstr("DH keys cannot place a planar joint"));
}

}  // namespace
}  // namespace flatdyn
