// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include "robot/model/angles.hpp"
#include "robot/model/coupling.hpp"
#include "unit/input/robot_file.hpp"

namespace flatdyn {
namespace {

using Kind = Displacement::Kind;

class UrdfReader : public RobotFiles {
 protected:
  Joint joint(const std::string& type, const std::string& elements, const std::string& more = "") {
    return read("r.urdf", one_joint_urdf(type, elements, more)).joints.at(0);
  }
};

TEST_F(UrdfReader, ReadsDecimalsExactly) {
  const Robot robot = read("r.urdf", R"(<robot name="r">
  <link name="base"/>
  <link name="arm">
    <inertial>
      <origin xyz="0.1 -2e-3 .5" rpy="0 0 0.3"/>
      <mass value="0.1"/>
      <inertia ixx="0.3" ixy="0.01" ixz="0.02" iyy="0.2" iyz="0.03" izz="0.4"/>
    </inertial>
  </link>
  <joint name="j" type="revolute"><parent link="base"/><child link="arm"/></joint>
</robot>)");
  const Inertial& inertial = robot.links.at(1).inertials.at(0);
  EXPECT_TRUE(inertial.mass.number.is_equal(Number(1) / 10));
  EXPECT_EQ(inertial.mass.place.line, 6);
  EXPECT_TRUE(inertial.tensor[1][2].is_equal(Number(3) / 100));
  EXPECT_TRUE(inertial.tensor[2][0].is_equal(Number(2) / 100));
  ASSERT_EQ(inertial.frame.displacements.size(), 2U);
  EXPECT_EQ(inertial.frame.displacements[0].kind, Kind::translation);
  EXPECT_TRUE(inertial.frame.displacements[0].translation[1].is_equal(Number(-2) / 1000));
  EXPECT_EQ(inertial.frame.displacements[1].kind, Kind::rotation_z);
  EXPECT_TRUE(inertial.frame.displacements[1].angle.is_equal(Number(3) / 10));
  EXPECT_TRUE(robot.gravity[2].is_equal(Number(-981) / 100));
  EXPECT_EQ(robot.links.at(static_cast<std::size_t>(robot.root)).name, "base");
  EXPECT_EQ(robot.links.at(static_cast<std::size_t>(robot.tip)).name, "arm");
}

TEST_F(UrdfReader, TakesRpyAsRzRyRx) {
  const Joint j = joint("revolute", R"(<origin xyz="0 0 1" rpy="0.1 0.2 0.3"/>)");
  ASSERT_EQ(j.origin.displacements.size(), 4U);
  EXPECT_EQ(j.origin.displacements[0].kind, Kind::translation);
  EXPECT_EQ(j.origin.displacements[1].kind, Kind::rotation_z);
  EXPECT_TRUE(j.origin.displacements[1].angle.is_equal(Number(3) / 10));
  EXPECT_EQ(j.origin.displacements[2].kind, Kind::rotation_y);
  EXPECT_EQ(j.origin.displacements[3].kind, Kind::rotation_x);
  EXPECT_TRUE(j.link_offset.displacements.empty());
}

TEST_F(UrdfReader, HasTheDefaultAxisOfUrdf) {
  EXPECT_TRUE(joint("revolute", "").axis[0].is_equal(1));
  const Joint j = joint("prismatic", R"(<axis xyz="0.1 0 -0.2"/>)");
  EXPECT_EQ(j.type, JointType::prismatic);
  EXPECT_TRUE(j.axis[0].is_equal(Number(1) / 10));  // left as written: not normalised
}

TEST_F(UrdfReader, ReadsFrictionAndLimits) {
  const Joint j = joint("revolute", R"(<dynamics damping="0.5" friction="0.25"/>
      <limit lower="-1" upper="2" velocity="3" effort="4" drake:acceleration="5"/>)");
  EXPECT_TRUE(j.viscous.number.is_equal(Number(1) / 2));
  EXPECT_TRUE(j.coulomb.number.is_equal(Number(1) / 4));
  EXPECT_TRUE(j.limits.lower->number.is_equal(-1));
  EXPECT_TRUE(j.limits.upper->number.is_equal(2));
  EXPECT_TRUE(j.limits.velocity->number.is_equal(3));
  EXPECT_TRUE(j.limits.effort->number.is_equal(4));
  EXPECT_TRUE(j.limits.acceleration->number.is_equal(5));
}

TEST_F(UrdfReader, TakesInfiniteAndHugeLimitsForNone) {
  const Joint j = joint("revolute", R"(<limit lower="-inf" upper="INF" velocity="1e308" effort="4"/>)");
  EXPECT_FALSE(j.limits.lower || j.limits.upper || j.limits.velocity);
  EXPECT_TRUE(j.limits.effort.has_value());
}

TEST_F(UrdfReader, LeavesTheRangeOfAContinuousJointOut) {
  const Joint j = joint("continuous", R"(<limit lower="-1" upper="1" velocity="3" effort="4"/>)");
  EXPECT_EQ(j.type, JointType::continuous);
  EXPECT_FALSE(j.limits.lower || j.limits.upper);
}

TEST_F(UrdfReader, ReadsArmature) {
  EXPECT_TRUE(joint("revolute", R"(<dynamics armature="0.01"/>)").armature.number.is_equal(Number(1) / 100));
}

TEST_F(UrdfReader, ReadsDrakesRotorInTheJoint) {
  const Joint j = joint("revolute", R"(<drake:rotor_inertia value="1e-4"/><drake:gear_ratio value="50"/>)");
  EXPECT_TRUE(j.armature.number.is_equal(Number(1) / 4));
  EXPECT_FALSE(j.motor.has_value());
}

constexpr const char* kTransmission = R"(<transmission name="t"><type>transmission_interface/SimpleTransmission</type>
    <joint name="j"/><actuator name="m"><mechanicalReduction> 100 </mechanicalReduction>)";

TEST_F(UrdfReader, ReadsDrakesRotorInTheActuator) {
  const std::string rotor = R"(<drake:rotor_inertia value="1e-4"/>)";
  const std::string end = "</actuator></transmission>";
  // The reduction of the transmission counts; Drake's own tag comes first.
  EXPECT_TRUE(joint("revolute", "", kTransmission + rotor + end).armature.number.is_equal(1));
  const std::string ratio = R"(<drake:gear_ratio value="-20"/>)";
  EXPECT_TRUE(joint("revolute", "", kTransmission + rotor + ratio + end).armature.number.is_equal(Number(4) / 100));
  // A rotor in the joint, too, is geared by the transmission.
  EXPECT_TRUE(joint("revolute", rotor, kTransmission + end).armature.number.is_equal(1));
}

TEST_F(UrdfReader, AReductionWithoutRotorChangesNothingAndSaysSo) {
  EXPECT_TRUE(
      joint("revolute", "", std::string(kTransmission) + "</actuator></transmission>").armature.number.is_zero());
  ASSERT_EQ(diagnostics_.all().size(), 1U);
  EXPECT_EQ(diagnostics_.all()[0].severity, Severity::note);
  EXPECT_NE(diagnostics_.all()[0].message.find("has no effect without a rotor inertia"), std::string::npos);
}

TEST_F(UrdfReader, ReadsRotorsWithoutNamespace) {
  for (const std::string rotor :
       {R"(<rotor_inertia value="1e-4"/><gear_ratio value="50"/>)",
        R"(<rotor_inertia>1e-4</rotor_inertia><gear_ratio> -50 </gear_ratio>)",
        R"(<actuator><motorInertia>1e-4</motorInertia><gear_ratio>50</gear_ratio></actuator>)"}) {
    EXPECT_TRUE(joint("revolute", rotor).armature.number.is_equal(Number(1) / 4)) << rotor;
    ASSERT_EQ(diagnostics_.all().size(), 1U);
    EXPECT_NE(diagnostics_.all()[0].message.find("counts as armature, 0.25 kg m^2"), std::string::npos);
  }
  const std::string rotor = "<motorInertia>1e-4</motorInertia>";
  const std::string end = "</actuator></transmission>";
  EXPECT_TRUE(joint("revolute", "", kTransmission + rotor + end).armature.number.is_equal(1));
  EXPECT_TRUE(joint("revolute", rotor, kTransmission + end).armature.number.is_equal(1));
  // The gear of an actuator that has no rotor multiplies nothing.
  const std::string two = "</actuator><actuator name=\"n\"><mechanicalReduction>7</mechanicalReduction>" + end;
  EXPECT_TRUE(joint("revolute", "", kTransmission + rotor + two).armature.number.is_equal(1));
}

TEST_F(UrdfReader, FindsValuesWhereverTheyStand) {
  for (const std::string axis : {R"(<axis xyz="0 1 0"/>)", "<axis><xyz>0 1 0</xyz></axis>", "<axis> 0\n1 0 </axis>",
                                 R"(<axis><xyz value="0 1 0"/></axis>)", "<axis><!-- y --><xyz>0 1 0</xyz></axis>",
                                 R"(<axis xyz="0 1 0"><xyz>0 1.0 0e3</xyz></axis>)"}) {
    const Joint j = joint("revolute", axis);
    EXPECT_TRUE(j.axis[1].is_equal(1) && j.axis[0].is_zero()) << axis;
  }
  const Joint j = joint("revolute", R"(<dynamics><damping>10</damping><friction value="2"/></dynamics>
      <origin><xyz>0 0 1</xyz><rpy>0 0 0.3</rpy></origin>
      <limit min="-1"><upper>2</upper></limit>)");
  EXPECT_TRUE(j.viscous.number.is_equal(10) && j.coulomb.number.is_equal(2));
  EXPECT_EQ(j.origin.displacements.size(), 2U);
  EXPECT_TRUE(j.limits.lower->number.is_equal(-1) && j.limits.upper->number.is_equal(2));
  EXPECT_TRUE(std::all_of(diagnostics_.all().begin(), diagnostics_.all().end(),
                          [](const Diagnostic& note) { return note.kind == "values read from unusual places"; }));
  EXPECT_EQ(diagnostics_.all().size(), 6U);
}

TEST_F(UrdfReader, FindsMimicsValuesWhereverTheyStand) {
  const std::string follower = R"(<link name="hand"/><joint name="k" type="revolute"><parent link="arm"/>
      <child link="hand"/><mimic><joint>j</joint><multiplier>-2</multiplier><offset value="0.1"/></mimic></joint>)";
  const Robot robot = read("r.urdf", one_joint_urdf("revolute", "", follower));
  const std::optional<Coupled>& coupled = robot.joints.at(1).coupled;
  ASSERT_TRUE(coupled.has_value());
  EXPECT_TRUE(coupled->terms.at(0).factor.is_equal(-2) && coupled->offset.is_equal(Number(1) / 10));
}

TEST_F(UrdfReader, ReadsFrictionOfOlderFiles) {
  const Joint j = joint("revolute", R"(<dynamics damping="0.5"/><joint_properties damping="0.50" friction="3"/>)");
  EXPECT_TRUE(j.viscous.number.is_equal(Number(1) / 2) && j.coulomb.number.is_equal(3));
  EXPECT_EQ(diagnostics_.all().size(), 1U);
}

TEST_F(UrdfReader, ReadsLinksWithoutAttributes) {
  const Robot robot = read("r.urdf", R"(<robot name="r"><link name="base"/><link name="arm"><inertial><mass>2</mass>
      <inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz><iyx>0.1</iyx></inertia></inertial></link>
      <joint name="j" type="revolute"><parent>base</parent><child> arm </child></joint></robot>)");
  const Inertial& inertial = robot.links.at(1).inertials.at(0);
  EXPECT_TRUE(inertial.mass.number.is_equal(2));
  EXPECT_TRUE(inertial.tensor[0][1].is_equal(Number(1) / 10));
  EXPECT_EQ(robot.joints.at(0).child, 1);
}

TEST_F(UrdfReader, TakesProductsOfInertiaTwiceWhereTheyAgree) {
  read("r.urdf", R"(<robot name="r"><link name="base"/><link name="arm"><inertial><mass value="2"/>
      <inertia ixx="1" ixy="0.1" ixz="0" iyx="0.10" iyy="1" iyz="0" izx="0.0" izy="0" izz="1"/></inertial></link>
      <joint name="j" type="revolute"><parent link="base"/><child link="arm"/></joint></robot>)");
  EXPECT_TRUE(diagnostics_.all().empty());
}

TEST_F(UrdfReader, TakesNegativeLimitsAndDustForNothing) {
  const Joint j = joint("revolute", R"(<origin rpy="-4.9305E-36 0 1e-99999"/><limit effort="-1" velocity="-1"/>)");
  EXPECT_FALSE(j.limits.effort || j.limits.velocity);
  EXPECT_TRUE(j.origin.displacements.empty());
  EXPECT_FALSE(diagnostics_.has_warnings());
}

TEST_F(UrdfReader, KnowsTheWorld) {
  const Robot robot = read(
      "r.urdf", one_joint_urdf("revolute", "",
                               R"(<joint name="w" type="fixed"><parent link="world"/><child link="base"/></joint>)"));
  EXPECT_EQ(robot.links.at(static_cast<std::size_t>(robot.root)).name, "world");
  EXPECT_EQ(diagnostics_.all().size(), 1U);
}

// Little and big endian, with and without a byte order mark.
TEST_F(UrdfReader, ReadsUtf16) {
  const std::string ascii = one_joint_urdf("revolute", "");
  std::string little, big;
  for (const char c : ascii) {
    little += {c, '\0'};
    big += {'\0', c};
  }
  for (const std::string& text : {little, big, "\xFF\xFE" + little, "\xFE\xFF" + big}) {
    EXPECT_EQ(read("r.urdf", text).joints.size(), 1U);
    EXPECT_EQ(diagnostics_.all().at(0).message, "the file is UTF-16: it is read as that");
  }
  EXPECT_FALSE(read_robot(write("r.urdf", little + "x"), {}, diagnostics_).has_value());
}

TEST_F(UrdfReader, IgnoresProcessingInstructions) {
  const std::string robot = one_joint_urdf("revolute", "<?editor a='>'?>", "<!-- <? --><?x?>");
  const std::string declaration = "<?xml version=\"1.0\"?>\n";
  EXPECT_EQ(read("r.urdf", "<!-- licence -->\n" + declaration + "<!DOCTYPE robot>" + robot).joints.size(), 1U);
  EXPECT_TRUE(diagnostics_.all().empty());
  EXPECT_FALSE(read_robot(write("r.urdf", declaration + "<robot>\n<?x?\n<link>"), {}, diagnostics_).has_value());
}

TEST_F(UrdfReader, JointsMayHaveNamesThatDifferInNoLetter) {
  const std::string more = R"(<link name="尖"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1"/></inertial>
      </link><joint name="关节 一" type="revolute"><parent link="arm"/><child link="尖"/></joint>)";
  EXPECT_EQ(read("r.urdf", one_joint_urdf("revolute", "", more)).joints.at(1).name, "关节 一");
  EXPECT_TRUE(diagnostics_.all().empty());
}

TEST_F(UrdfReader, OfAFixedJointOnlyItsPlaceMatters) {
  joint("revolute", "", R"(<link name="h"/><joint name="k" type="fixed"><parent link="arm"/><child link="h"/>
      <axis/><limit uper="1"/><dynamics dampening="1"/></joint>)");
  EXPECT_TRUE(diagnostics_.all().empty());
}

TEST_F(UrdfReader, IgnoresWhatDoesNotMove) {
  joint(
      "revolute", "<calibration rising=\"0\"/><safety_controller k_velocity=\"1\"/>",
      R"(<gazebo><joint name="j" type="depth"/></gazebo><material name="m"/><sensor name="s"><joint type="ball"/></sensor>)");
  EXPECT_TRUE(diagnostics_.all().empty());
}

TEST_F(UrdfReader, TakesSpringsThatDoNothing) {
  joint("revolute", R"(<dynamics spring_stiffness="0" stiffness="0.0" spring_reference="1"/>)",
        R"(<gazebo reference="j"><springStiffness>0.0</springStiffness><springReference>1</springReference></gazebo>)");
  EXPECT_TRUE(diagnostics_.all().empty());
  joint("revolute", "", R"(<link name="h"/><joint name="k" type="fixed"><parent link="arm"/><child link="h"/>
      <dynamics spring_stiffness="3"/></joint>
      <gazebo reference="k"><springStiffness>3</springStiffness></gazebo>)");
  EXPECT_TRUE(diagnostics_.all().empty());
}

TEST_F(UrdfReader, ReadsSpringsInDynamicsAndGazebo) {
  const Joint first = joint("revolute", R"(<dynamics spring_stiffness="3" spring_reference="0.25"/>)");
  const Joint second = joint("revolute", R"(<dynamics stiffness="3"/>)", R"(<gazebo reference="j">
      <springStiffness>3</springStiffness><springReference> 0.25 </springReference></gazebo>)");
  for (const Joint& each : {first, second}) {
    EXPECT_TRUE(each.stiffness.number.is_equal(3));
    EXPECT_TRUE(each.spring_reference.number.is_equal(Number(1) / 4));
  }
  EXPECT_TRUE(diagnostics_.all().empty());
}

TEST_F(UrdfReader, RefusesLoopsAndSpringsOfNoJoint) {
  for (const auto& [more, is_unsupported] :
       {std::pair(R"(<gazebo><joint name="l" type="revolute"><child>base</child></joint></gazebo>)", true),
        std::pair(R"(<gazebo reference="arm"><springStiffness>1</springStiffness></gazebo>)", false)}) {
    diagnostics_ = {};
    EXPECT_FALSE(read_robot(write("r.urdf", one_joint_urdf("revolute", "", more)), {}, diagnostics_).has_value());
    EXPECT_EQ(diagnostics_.only_unsupported(), is_unsupported);
  }
}

TEST_F(UrdfReader, TheNameOfTheFileMustBeUtf8WhereTheRobotTakesIt) {
  const std::string named = one_joint_urdf("revolute", "");
  EXPECT_TRUE(read_robot(write("r\xFF.urdf", named), {}, diagnostics_).has_value());
  const std::string nameless = "<robot>" + named.substr(named.find('>') + 1);
  EXPECT_FALSE(read_robot(write("r\xFF.urdf", nameless), {}, diagnostics_).has_value());
  EXPECT_EQ(diagnostics_.all().at(0).message, "the name of the file, which the robot takes, is not UTF-8");
}

TEST_F(UrdfReader, LeavesNamesOfOthersAlone) {
  joint("revolute", R"(<limit mujoco:margin="1" drake:jerk="2" effort="1" velocity="1"/><drake:contact_model value="1"/>
      <hardwareInterface/><sensor/>)",
        "<!-- done --><group/>");
  ASSERT_EQ(diagnostics_.all().size(), 2U);
  for (const Diagnostic& note : diagnostics_.all()) EXPECT_EQ(note.kind, "unknown elements not read");
}

constexpr const char* kTree = R"(<robot name="tree">
  <link name="a"/><link name="b"/><link name="c"/><link name="d"/><link name="e"/>
  <joint name="ab" type="revolute"><parent link="a"/><child link="b"/></joint>
  <joint name="ac" type="fixed"><parent link="a"/><child link="c"/></joint>
  <joint name="cd" type="continuous"><parent link="c"/><child link="d"/></joint>
  <joint name="be" type="prismatic"><parent link="b"/><child link="e"/></joint>
</robot>)";

TEST_F(UrdfReader, OrdersJointsDepthFirst) {
  const Robot robot = read("tree.urdf", kTree);
  std::vector<std::string> names;
  for (const int j : moving_joints(robot)) names.push_back(robot.joints[static_cast<std::size_t>(j)].name);
  EXPECT_EQ(names, (std::vector<std::string>{"ab", "be", "cd"}));
  EXPECT_EQ(robot.links[static_cast<std::size_t>(robot.tip)].name, "d");
}

TEST_F(UrdfReader, TakesTheOptions) {
  ReadOptions options;
  options.tip = "e";
  options.scene.gravity = Vec3{0, 1, 2};
  options.scene.locked = {{"ab"}};
  const Robot robot = read("tree.urdf", kTree, options);
  EXPECT_EQ(robot.links[static_cast<std::size_t>(robot.tip)].name, "e");
  EXPECT_TRUE(robot.gravity[2].is_equal(2));
  EXPECT_EQ(robot.joints[0].type, JointType::fixed);
  EXPECT_EQ(moving_joints(robot).size(), 2U);
}

TEST_F(UrdfReader, ReportsUnknownNamesOfTheOptions) {
  ReadOptions options;
  options.tip = "f";
  options.scene.locked = {{"ax"}};
  const auto path = write("tree.urdf", kTree);
  EXPECT_FALSE(read_robot(path, options, diagnostics_).has_value());
  ASSERT_GE(diagnostics_.all().size(), 2U);
  EXPECT_EQ(to_string(diagnostics_.all()[0]),
            "flatdyn: error: there is no joint \"ax\" to be fixed\n    hint: did you mean \"ab\"?");
  EXPECT_EQ(to_string(diagnostics_.all()[1]),
            "flatdyn: error: --tip: there is no link \"f\"\n    hint: known links: a, b, c, d, e");
}

TEST_F(UrdfReader, HoldsMimicAndFloatingJointsIfTold) {
  ReadOptions options;
  options.scene.locked = {{"k"}, {"f"}};
  const std::string more = R"(<link name="hand"/><joint name="k" type="revolute"><parent link="arm"/>
      <child link="hand"/><mimic joint="j"/></joint><link name="eye"/><joint name="f" type="floating">
      <parent link="hand"/><child link="eye"/></joint>)";
  const Robot robot = read("r.urdf", one_joint_urdf("revolute", "", more), options);
  EXPECT_EQ(moving_joints(robot).size(), 1U);
}

TEST_F(UrdfReader, AMimicJointFollowsAnother) {
  const std::string more = R"(<link name="hand"/><joint name="k" type="prismatic"><parent link="arm"/>
      <child link="hand"/><mimic joint="j" multiplier="-0.05" offset="0.01"/></joint>)";
  const Robot robot = read("r.urdf", one_joint_urdf("revolute", "", more), {});
  EXPECT_EQ(moving_joints(robot).size(), 2U);
  ASSERT_EQ(joints_with_coordinates(robot), std::vector<int>{0});
  const LinearPosition position = joint_positions(robot)[1];
  EXPECT_EQ(position.factors.at(0), Number(-5) / 100);
  EXPECT_EQ(position.offset, Number(1) / 100);
}

TEST_F(UrdfReader, AJointThatTurnsMayMimicByAFraction) {
  const std::string more = R"(<link name="hand"/><joint name="k" type="revolute"><parent link="arm"/>
      <child link="hand"/><limit effort="1" velocity="1" lower="0" upper="1"/><mimic joint="j" multiplier="1.13"/>
      </joint>)";
  const Mechanism mechanism = make_mechanism(read("r.urdf", one_joint_urdf("revolute", "", more), {}));
  EXPECT_EQ(mechanism.size(), 1);
  ASSERT_EQ(mechanism.angles.size(), 1U);
  EXPECT_EQ(mechanism.angles[0].factor, Number(113) / 100);
  EXPECT_EQ(angle_factors(mechanism, 1), (std::vector<Number>{0, 1}));
}

TEST_F(UrdfReader, AFollowerOfAHeldJointIsHeldToo) {
  ReadOptions options;
  options.scene.locked = {{"j", Number(1) / 2, "0.5", true, {}}};
  const std::string more = R"(<link name="hand"/><joint name="k" type="prismatic"><parent link="arm"/>
      <child link="hand"/><mimic joint="j" multiplier="2" offset="0.1"/></joint><link name="finger"/>
      <joint name="l" type="revolute"><parent link="hand"/><child link="finger"/></joint>)";
  const Robot robot = read("r.urdf", one_joint_urdf("revolute", "", more), options);
  EXPECT_EQ(moving_joints(robot).size(), 1U);
  ASSERT_TRUE(robot.joints[1].held.has_value());
  EXPECT_EQ(robot.joints[1].held->position, Number(11) / 10);
}

TEST_F(UrdfReader, AFixedJointMayMimic) {
  EXPECT_EQ(moving_joints(read("r.urdf", one_joint_urdf("revolute", "", R"(<link name="h"/><joint name="k" type="fixed">
      <parent link="arm"/><child link="h"/><mimic joint="j"/></joint>)")))
                .size(),
            1U);
}

TEST_F(UrdfReader, AMissingFileEndsWithIo) {
  try {
    read_robot(folder_ / "nothing.urdf", {}, diagnostics_);
    FAIL() << "no exception";
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.kind(), FailureKind::io);
  }
  EXPECT_THROW(read_robot(folder_, {}, diagnostics_), Failure);
}

TEST_F(UrdfReader, RefusesAFileThatIsTooLarge) {
  const auto path = write("large.urdf", "<robot>");
  std::filesystem::resize_file(path, std::uintmax_t{65} * 1024 * 1024);  // sparse: takes no room
  EXPECT_FALSE(read_robot(path, {}, diagnostics_).has_value());
  EXPECT_EQ(diagnostics_.all().at(0).message, "the file is larger than 64 MB");
}

// A joint beside a floating base is held and left out; the joint that follows it stands where it leads.
TEST_F(UrdfReader, KnowsWhereJointsThatAreLeftOutStand) {
  const std::string mass =
      R"(<inertial><mass value="2"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>)";
  ReadOptions held;
  held.scene.locked = {{"spare", 0.5, "0.5", true}};
  const Robot robot =
      read("r.urdf",
           R"(<robot name="r"><link name="world"/><link name="trunk">)" + mass + R"(</link><link name="leg">)" + mass +
               R"(</link><link name="dummy">)" + mass + R"(</link>
    <joint name="free" type="floating"><parent link="world"/><child link="trunk"/></joint>
    <joint name="hip" type="continuous"><parent link="trunk"/><child link="leg"/><mimic joint="spare" multiplier="2"/></joint>
    <joint name="spare" type="continuous"><parent link="world"/><child link="dummy"/></joint></robot>)",
           held);
  ASSERT_EQ(robot.joints.size(), 1U);
  EXPECT_EQ(robot.joints[0].held.value().position, 1);
}

TEST_F(UrdfReader, ExpandsNoEntities) {
  const std::string bomb = R"(<!DOCTYPE r [<!ENTITY a "0000000000"><!ENTITY b "&a;&a;&a;&a;&a;&a;&a;&a;">]>)";
  const auto path = write("bomb.urdf", bomb + one_joint_urdf("revolute", R"(<origin xyz="&b; 0 0"/>)"));
  EXPECT_FALSE(read_robot(path, {}, diagnostics_).has_value());
}

}  // namespace
}  // namespace flatdyn
