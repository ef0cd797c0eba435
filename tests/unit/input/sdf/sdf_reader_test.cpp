// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include "robot/model/mechanism.hpp"
#include "unit/input/robot_file.hpp"
#include "unit/input/sdf/sdf_text.hpp"

namespace flatdyn {
namespace {

using Kind = Displacement::Kind;

class SdfReader : public RobotFiles {
 protected:
  Robot model(const std::string& contents, const std::string& version = "1.9", const ReadOptions& options = {}) {
    return read("r.sdf", sdf_model(contents, version), options);
  }
  Joint joint(const std::string& type, const std::string& elements, const std::string& version = "1.9") {
    return model(kBaseAndArm + sdf_joint(type, elements), version).joints.at(0);
  }
  std::string first_message() const { return diagnostics_.all().empty() ? "" : diagnostics_.all().front().message; }
};

TEST_F(SdfReader, ReadsDecimalsExactly) {
  const Robot robot = model(R"(
  <link name="base"/>
  <link name="arm">
    <inertial>
      <pose>0.1 -2e-3 .5 0 0 0.3</pose>
      <mass>0.1</mass>
      <inertia><ixx>0.3</ixx><ixy>0.01</ixy><ixz>0.02</ixz><iyy>0.2</iyy><iyz>0.03</iyz><izz>0.4</izz></inertia>
    </inertial>
  </link>
  <joint name="j" type="revolute"><parent>base</parent><child>arm</child><axis><xyz>0 0 1</xyz></axis></joint>)");
  EXPECT_EQ(robot.name, "r");
  const Inertial& inertial = robot.links.at(1).inertials.at(0);
  EXPECT_TRUE(inertial.mass.number.is_equal(Number(1) / 10));
  EXPECT_EQ(inertial.mass.place.line, 6);
  EXPECT_TRUE(inertial.tensor[1][2].is_equal(Number(3) / 100));
  ASSERT_EQ(inertial.frame.displacements.size(), 2U);
  EXPECT_TRUE(inertial.frame.displacements[0].translation[1].is_equal(Number(-2) / 1000));
  EXPECT_EQ(inertial.frame.displacements[1].kind, Kind::rotation_z);
  EXPECT_TRUE(inertial.frame.displacements[1].angle.is_equal(Number(3) / 10));
  EXPECT_EQ(inertial.about, Inertial::About::centre_of_mass);
  EXPECT_TRUE(robot.gravity[2].is_equal(Number(-981) / 100));
  EXPECT_EQ(robot.links.at(static_cast<std::size_t>(robot.root)).name, "base");
}

TEST_F(SdfReader, HasTheDefaultMassAndInertiaOfSdf) {
  const Robot robot =
      model(R"(<link name="base"/><link name="arm"><inertial/></link>)" + sdf_joint("revolute", kAxisZ));
  for (const Link& link : robot.links) {
    EXPECT_TRUE(link.inertials.at(0).mass.number.is_equal(1));
    EXPECT_TRUE(link.inertials.at(0).tensor[2][2].is_equal(1));
    EXPECT_TRUE(vanishes(link.inertials.at(0).tensor[0][1]));
  }
  EXPECT_EQ(first_message(), "link \"base\" has no <inertial>: it counts as 1 kg, and 1 kg m^2 about each axis");
}

TEST_F(SdfReader, PlacesTheJointInTheFrameOfItsChild) {
  const Robot robot = model(R"(
    <link name="base"><pose>0 0 1 0 0 0</pose></link>
    <link name="arm"><pose>1 0 0 0 0 1.5707963267948966</pose></link>
    <joint name="j" type="prismatic"><pose>0 0.5 0 0 0 0</pose><parent>base</parent><child>arm</child>
      <axis><xyz>1 0 0</xyz></axis></joint>)");
  const Joint& joint = robot.joints.at(0);
  EXPECT_EQ(joint.type, JointType::prismatic);
  // The base is at z = 1 of the model, the arm turned by a quarter: (1, 0, -1), Rz(pi/2), (0, 0.5, 0).
  ASSERT_EQ(joint.origin.displacements.size(), 3U);
  EXPECT_TRUE(joint.origin.displacements[0].translation[2].is_equal(-1));
  EXPECT_TRUE(joint.origin.displacements[1].angle.is_equal(GiNaC::Pi / 2));
  EXPECT_TRUE(joint.origin.displacements[2].translation[1].is_equal(Number(1) / 2));
  ASSERT_EQ(joint.link_offset.displacements.size(), 1U);
  EXPECT_TRUE(joint.link_offset.displacements[0].translation[1].is_equal(Number(-1) / 2));
}

TEST_F(SdfReader, KeepsTheDecimalsOfAnAxisInAnotherFrame) {
  const std::string links = R"(<link name="base"/><link name="arm"><pose>0 0 1 0.1 0 0</pose></link>)";
  const Joint joint =
      model(links + sdf_joint("revolute", R"(<axis><xyz expressed_in="__model__">0 0.6 0.8</xyz></axis>)"))
          .joints.at(0);
  EXPECT_TRUE(joint.axis[1].is_equal(Number(3) / 5));
  // The joint's frame has the axes of the model; the arm is turned against it.
  ASSERT_EQ(joint.origin.displacements.size(), 1U);
  EXPECT_EQ(joint.origin.displacements[0].kind, Kind::translation);
  ASSERT_EQ(joint.link_offset.displacements.size(), 1U);
  EXPECT_TRUE(joint.link_offset.displacements[0].angle.is_equal(Number(1) / 10));
}

TEST_F(SdfReader, TakesAxesOfOldFilesInTheFrameOfTheModel) {
  const std::string links = R"(<link name="base"/><link name="arm"><pose>0 0 1 0.1 0 0</pose></link>)";
  const std::string in_model = R"(<axis><xyz>0 0 1</xyz><use_parent_model_frame>1</use_parent_model_frame></axis>)";
  const auto is_turned = [&](const std::string& axis, const std::string& version) {
    return !model(links + sdf_joint("revolute", axis), version).joints.at(0).link_offset.displacements.empty();
  };
  EXPECT_TRUE(is_turned(kAxisZ, "1.4"));
  EXPECT_FALSE(is_turned(kAxisZ, "1.5"));
  EXPECT_TRUE(is_turned(in_model, "1.6"));
}

TEST_F(SdfReader, ReadsFrictionSpringsAndLimits) {
  const Joint j = joint("revolute", R"(<axis><xyz>0 0 1</xyz>
    <dynamics><damping>0.5</damping><friction>0.25</friction><spring_stiffness>12</spring_stiffness>
      <spring_reference>-0.5</spring_reference></dynamics>
    <limit><lower>-1</lower><upper>2</upper><velocity>3</velocity><effort>-1</effort></limit></axis>)");
  EXPECT_TRUE(j.viscous.number.is_equal(Number(1) / 2));
  EXPECT_TRUE(j.coulomb.number.is_equal(Number(1) / 4));
  EXPECT_TRUE(j.stiffness.number.is_equal(12));
  EXPECT_TRUE(j.spring_reference.number.is_equal(Number(-1) / 2));
  EXPECT_TRUE(j.limits.lower->number.is_equal(-1));
  EXPECT_TRUE(j.limits.velocity->number.is_equal(3));
  EXPECT_FALSE(j.limits.effort.has_value());  // negative: not enforced
}

TEST_F(SdfReader, ReadsDrakesRotorAndAcceleration) {
  const Joint j = joint("revolute", R"(<axis><xyz>0 0 1</xyz>
    <limit><drake:acceleration>5</drake:acceleration></limit></axis>
    <drake:rotor_inertia>1e-4</drake:rotor_inertia><drake:gear_ratio>50</drake:gear_ratio>)");
  EXPECT_TRUE(j.armature.number.is_equal(Number(1) / 4));
  EXPECT_TRUE(j.limits.acceleration->number.is_equal(5));
}

TEST_F(SdfReader, ReadsAMimic) {
  const Robot robot = model(kBaseAndArm + sdf_joint("revolute", kAxisZ) + R"(<link name="hand"/>
    <joint name="k" type="revolute"><parent>arm</parent><child>hand</child><axis><xyz>0 0 1</xyz>
      <mimic joint="j"><multiplier>2</multiplier><offset>0.5</offset><reference>0.1</reference></mimic>
      </axis></joint>)",
                            "1.11");
  const Coupled& coupled = robot.joints.at(1).coupled.value();
  EXPECT_EQ(coupled.terms.at(0).joint.name, "j");
  EXPECT_TRUE(coupled.terms.at(0).factor.is_equal(2));
  EXPECT_TRUE(coupled.offset.is_equal(Number(3) / 10));
}

TEST_F(SdfReader, MakesTwoJointsOfAUniversalOne) {
  const Robot robot =
      model(kBaseAndArm + sdf_joint("universal", R"(<axis><xyz>1 0 0</xyz></axis><axis2><xyz>0 1 0</xyz></axis2>)"));
  ASSERT_EQ(robot.joints.size(), 2U);
  EXPECT_EQ(robot.joints[0].name, "j.axis");
  EXPECT_EQ(robot.joints[1].name, "j.axis2");
  EXPECT_EQ(robot.links.at(static_cast<std::size_t>(robot.joints[0].child)).name, "j.between");
  EXPECT_EQ(robot.links.at(static_cast<std::size_t>(robot.joints[1].child)).name, "arm");
  EXPECT_TRUE(robot.joints[1].axis[1].is_equal(1));
  EXPECT_EQ(make_mechanism(robot).size(), 2);
}

TEST_F(SdfReader, ReadsAScrewAsAHingeAndASlideThatFollows) {
  for (const char* pitch : {"<screw_thread_pitch>0.5</screw_thread_pitch>",
                            "<screw_thread_pitch>.5</screw_thread_pitch><thread_pitch>7</thread_pitch>"}) {
    const Robot robot = model(kBaseAndArm + sdf_joint("screw", "<axis><xyz>0 1 0</xyz></axis>" + std::string(pitch)));
    ASSERT_EQ(robot.joints.size(), 2U);
    const Joint &hinge = robot.joints[0], &slide = robot.joints[1];
    EXPECT_EQ(hinge.name, "j");
    EXPECT_EQ(hinge.type, JointType::revolute);
    EXPECT_EQ(slide.name, "j.slide");
    EXPECT_EQ(slide.type, JointType::prismatic);
    EXPECT_TRUE(slide.axis[1].is_equal(1));
    ASSERT_TRUE(slide.coupled.has_value());
    EXPECT_EQ(slide.coupled->terms.at(0).joint.name, "j");
    EXPECT_TRUE(slide.coupled->terms.at(0).factor.is_equal(1 / (4 * GiNaC::Pi)));
    EXPECT_EQ(make_mechanism(robot).size(), 1);
  }
}

TEST_F(SdfReader, ReadsTheThreadOfOlderScrewsInRadiansPerMetre) {
  const Robot robot = model(kBaseAndArm + sdf_joint("screw", kAxisZ + "<thread_pitch>-8</thread_pitch>"), "1.9");
  EXPECT_TRUE(robot.joints.at(1).coupled->terms.at(0).factor.is_equal(Number(1) / 8));
}

TEST_F(SdfReader, ReadsPluginsThatLetAJointFollowAnotherOne) {
  const Robot robot = model(
      R"(<link name="base"/><link name="arm"/><link name="hand"/>)" + sdf_joint("revolute", kAxisZ) +
      R"(<joint name="k" type="revolute"><parent>arm</parent><child>hand</child><axis><xyz>0 0 1</xyz></axis></joint>
      <plugin name="p" filename="libgazebo_mimic_joint_plugin.so"><joint>j</joint><mimicJoint>k</mimicJoint>
        <multiplier>-2</multiplier><offset>0.5</offset></plugin>)");
  ASSERT_TRUE(robot.joints.at(1).coupled.has_value());
  const Coupled& coupled = *robot.joints[1].coupled;
  EXPECT_EQ(coupled.terms.at(0).joint.name, "j");
  EXPECT_TRUE(coupled.terms[0].factor.is_equal(-2));
  EXPECT_TRUE(coupled.offset.is_equal(Number(1) / 2));
}

std::string geared(const std::string& gearbox) {
  const auto hinge = [](const std::string& name, const std::string& axis) {
    return "<joint name=\"" + name + "\" type=\"revolute\"><parent>base</parent><child>" + name +
           "_body</child><axis><xyz>" + axis + "</xyz></axis></joint>";
  };
  return R"(<link name="base"/><link name="a_body"><pose>0 0 0 0 0 1.5707963267948966</pose></link>
      <link name="b_body"><pose>1 0 0 0 0 0</pose></link>)" +
         hinge("a", "0 0 1") + hinge("b", "0 0 -2") + R"(<joint name="g" type="gearbox"><parent>a_body</parent>
      <child>b_body</child>)" +
         gearbox + "</joint>";
}

// theta_2 = -ratio theta_1, both about z; b turns about -z.
TEST_F(SdfReader, CouplesTwoJointsByAGearbox) {
  const Robot robot = model(geared(R"(<gearbox_ratio>3</gearbox_ratio>
      <gearbox_reference_body>base</gearbox_reference_body><axis><xyz>0 0 1</xyz></axis>
      <axis2><xyz>0 0 1</xyz></axis2>)"));
  ASSERT_EQ(robot.joints.size(), 2U);
  ASSERT_TRUE(robot.joints[1].coupled.has_value());
  EXPECT_EQ(robot.joints[1].coupled->terms.at(0).joint.name, "a");
  EXPECT_TRUE(robot.joints[1].coupled->terms[0].factor.is_equal(3));
  EXPECT_EQ(make_mechanism(robot).size(), 1);
}

TEST_F(SdfReader, RefusesGearboxesThatDoNotCoupleTwoJoints) {
  const auto message = [this](const std::string& gearbox) {
    diagnostics_ = {};
    read_robot(write("r.sdf", sdf_model(geared(gearbox))), {}, diagnostics_);
    for (const Diagnostic& found : diagnostics_.all()) {
      if (found.severity == Severity::error) return found.message;
    }
    return std::string();
  };
  const std::string axes = "<axis><xyz>0 0 1</xyz></axis><axis2><xyz>0 0 1</xyz></axis2>";
  const auto of = [](const std::string& body) {
    return "<gearbox_reference_body>" + body + "</gearbox_reference_body>";
  };
  EXPECT_EQ(message(axes), "joint \"g\" has no <gearbox_reference_body>");
  EXPECT_EQ(
      message(of("a_body") + axes),
      "joint \"g\": its parent does not turn on its reference body by a joint of one axis, which is not supported");
  EXPECT_EQ(message(of("base") + "<axis><xyz>0 0 1</xyz></axis><axis2><xyz>0 1 0</xyz></axis2>"),
            "joint \"g\": its <axis2> is not parallel to the axis of joint \"b\", which is not supported");
  EXPECT_EQ(message(of("base") + "<axis><xyz>0 0 1</xyz><dynamics><damping>2</damping></dynamics></axis>"
                                 "<axis2><xyz>0 0 1</xyz></axis2>"),
            "joint \"g\": it has friction, a spring or a mimic, which is not supported");
}

TEST_F(SdfReader, HoldsBothPartsOfAUniversalJoint) {
  ReadOptions options;
  options.scene.locked = {{"u"}};
  const Robot robot = model(kBaseAndArm + sdf_joint("revolute", kAxisZ) + R"(<link name="hand"/>
    <joint name="u" type="universal"><parent>arm</parent><child>hand</child><axis><xyz>1 0 0</xyz></axis>
      <axis2><xyz>0 1 0</xyz></axis2></joint>)",
                            "1.9", options);
  EXPECT_EQ(robot.joints.at(1).type, JointType::fixed);
  EXPECT_EQ(robot.joints.at(2).type, JointType::fixed);
}

TEST_F(SdfReader, ReadsDegreesAndQuaternions) {
  const auto angle_of = [&](const std::string& pose) {
    const std::string links = R"(<link name="base"/><link name="arm">)" + pose + "</link>";
    return model(links + sdf_joint("revolute", kAxisZ)).joints.at(0).origin.displacements.at(0).angle;
  };
  EXPECT_TRUE(angle_of(R"(<pose degrees="true">0 0 0 0 0 90</pose>)").is_equal(GiNaC::Pi / 2));
  EXPECT_TRUE(
      angle_of(R"(<pose rotation_format="quat_xyzw">0 0 0 0 0 0.70710678 0.70710678</pose>)").is_equal(GiNaC::Pi / 2));
}

TEST_F(SdfReader, KeepsGravityWhereItIsWhenTheBaseIsTurned) {
  const Robot robot =
      model(R"(<link name="base"><pose>0 0 1 0.3 0 0</pose></link><link name="arm"/>)" + sdf_joint("revolute", kAxisZ));
  EXPECT_EQ(robot.links.at(static_cast<std::size_t>(robot.root)).name, "world");
  EXPECT_EQ(robot.joints.back().name, "world to base");
  EXPECT_EQ(first_message().substr(0, 11), "link \"base\"");
}

TEST_F(SdfReader, HoldsJointsThatAreToBeHeld) {
  ReadOptions options;
  options.scene.locked = {{"k"}};
  const Robot robot = model(kBaseAndArm + sdf_joint("revolute", kAxisZ) + R"(<link name="hand"/>
    <joint name="k" type="ball"><parent>arm</parent><child>hand</child></joint>)",
                            "1.9", options);
  EXPECT_EQ(robot.joints.at(1).type, JointType::fixed);
}

}  // namespace
}  // namespace flatdyn
