// SPDX-License-Identifier: GPL-2.0-or-later
// MJCF files: what is read of bodies, joints, classes of defaults, orientations and actuators. tests/differential
// compares whole robots with MuJoCo.
#include <gmock/gmock.h>

#include "robot/model/coupling.hpp"
#include "unit/input/robot_file.hpp"

namespace flatdyn {
namespace {

using ::testing::ElementsAre;

class MjcfReader : public RobotFiles {
 protected:
  Robot mjcf(const std::string& bodies, const std::string& before = "", const std::string& after = "",
             const ReadOptions& options = {}) {
    return read("r.xml", "<mujoco>" + before + "<worldbody>" + bodies + "</worldbody>" + after + "</mujoco>", options);
  }

  std::vector<std::string> messages() const {
    std::vector<std::string> all;
    for (const Diagnostic& found : diagnostics_.all()) all.push_back(found.message);
    return all;
  }
};

constexpr const char* kBodyOfTwoKilograms = "<inertial pos=\"0 0 0\" mass=\"2\" diaginertia=\"1 1 1\"/>";

std::string mjcf_body(const std::string& name, const std::string& more, const std::string& attributes = "") {
  return "<body name=\"" + name + "\" " + attributes + ">" + kBodyOfTwoKilograms + more + "</body>";
}

std::vector<std::string> joints_named_by(const std::vector<Reference>& references) {
  std::vector<std::string> names;
  for (const Reference& each : references) names.push_back(each.name);
  return names;
}

std::vector<std::string> joints_of(const Robot& robot) {
  std::vector<std::string> names;
  for (const Joint& joint : robot.joints) names.push_back(joint.name);
  return names;
}

std::string printed_exactly(const Number& number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

// Turns as text: "z 1/2*Pi".
std::string turns_in(const Pose& pose) {
  std::string text;
  for (const Displacement& each : pose.displacements) {
    const char* axis = each.kind == Displacement::Kind::rotation_x   ? "x "
                       : each.kind == Displacement::Kind::rotation_y ? "y "
                       : each.kind == Displacement::Kind::rotation_z ? "z "
                                                                     : nullptr;
    if (axis != nullptr) text += (text.empty() ? "" : ", ") + (axis + printed_exactly(each.angle));
  }
  return text;
}

TEST_F(MjcfReader, ReadsAHingeInDegrees) {
  const Robot robot = mjcf(
      mjcf_body("a", R"(<joint name="j" axis="0 1 0" range="-90 45" damping="3" armature="0.5" frictionloss="2"/>)"));
  ASSERT_EQ(robot.joints.size(), 1U);
  const Joint& joint = robot.joints[0];
  EXPECT_EQ(joint.type, JointType::revolute);
  EXPECT_EQ(printed_exactly(joint.limits.lower->number), "-1/2*Pi");
  EXPECT_EQ(printed_exactly(joint.limits.upper->number), "1/4*Pi");
  EXPECT_EQ(printed_exactly(joint.viscous.number), "3");
  EXPECT_EQ(printed_exactly(joint.armature.number), "1/2");
  EXPECT_EQ(printed_exactly(joint.coulomb.number), "2");
}

TEST_F(MjcfReader, ReadsRadiansWhereTheCompilerSaysSo) {
  const Robot robot = mjcf(mjcf_body("a", R"(<joint name="j" range="-1 2"/>)"), R"(<compiler angle="radian"/>)");
  EXPECT_EQ(printed_exactly(robot.joints[0].limits.upper->number), "2");
}

TEST_F(MjcfReader, HasNoLimitsWhereTheyAreTurnedOff) {
  const Robot robot = mjcf(mjcf_body("a", R"(<joint name="j" range="-1 2" limited="false"/>)"));
  EXPECT_FALSE(robot.joints[0].limits.lower);
  EXPECT_EQ(robot.joints[0].type, JointType::continuous);
}

TEST_F(MjcfReader, ReadsSeveralJointsOfABodyInOrder) {
  const Robot robot = mjcf(mjcf_body(
      "a", R"(<joint name="x" type="slide" axis="1 0 0"/><joint name="y" pos="0 0 1" axis="0 1 0"/><joint name="z"/>)",
      "pos=\"0 0 3\""));
  EXPECT_THAT(joints_of(robot), ElementsAre("x", "y", "z"));
  ASSERT_EQ(robot.links.size(), 4U);
  EXPECT_EQ(robot.links.back().name, "a");
  EXPECT_TRUE(robot.links[1].inertials.empty());
  EXPECT_EQ(printed_exactly(robot.joints[0].origin.displacements.front().translation[2]), "3");
  EXPECT_EQ(printed_exactly(robot.joints[1].origin.displacements.front().translation[2]), "1");
  EXPECT_EQ(printed_exactly(robot.joints[1].link_offset.displacements.front().translation[2]), "-1");
}

TEST_F(MjcfReader, TakesDefaultsOfTheNearestClass) {
  const Robot robot =
      mjcf("<body childclass=\"outer\" name=\"a\">" + std::string(kBodyOfTwoKilograms) + "<joint name=\"i\"/>" +
               "<body name=\"b\">" + kBodyOfTwoKilograms + "<joint name=\"j\" class=\"inner\"/></body></body>",
           R"(<default><joint damping="1"/><default class="outer"><default class="inner"><joint damping="3"/></default>
         <joint damping="2" armature="7"/></default></default>)");
  EXPECT_EQ(printed_exactly(robot.joints[0].viscous.number), "2");
  EXPECT_EQ(printed_exactly(robot.joints[1].viscous.number), "3");
  EXPECT_EQ(printed_exactly(robot.joints[1].armature.number), "7");
}

TEST_F(MjcfReader, ShiftsAJointByItsRef) {
  const Robot robot = mjcf(mjcf_body("a", R"(<joint name="j" ref="90"/>)") +
                           mjcf_body("b", R"(<joint name="k" type="slide" ref="2"/>)"));
  EXPECT_EQ(turns_in(robot.joints[0].origin), "z -1/2*Pi");
  EXPECT_EQ(printed_exactly(robot.joints[1].origin.displacements.front().translation[2]), "-2");
}

TEST_F(MjcfReader, MovesWhatIsInAFrame) {
  const Robot robot = mjcf(R"(<frame pos="1 0 0" euler="0 90 0">)" +
                           mjcf_body("a", R"(<joint name="j"/>)", R"(pos="0 0 2")") + "</frame>");
  EXPECT_EQ(turns_in(robot.joints[0].origin), "y 1/2*Pi");
  EXPECT_EQ(robot.joints[0].origin.displacements.size(), 3U);
}

struct OrientationForm {
  const char* name;
  const char* attribute;
  const char* compiler;
  const char* turns;
};

class MjcfOrientations : public MjcfReader, public ::testing::WithParamInterface<OrientationForm> {};

TEST_P(MjcfOrientations, AreExact) {
  const Robot robot = mjcf(mjcf_body("a", R"(<joint name="j"/>)", GetParam().attribute), GetParam().compiler);
  EXPECT_EQ(turns_in(robot.joints[0].origin), GetParam().turns);
  EXPECT_TRUE(robot.snaps.empty());
}

INSTANTIATE_TEST_SUITE_P(
    Forms, MjcfOrientations,
    ::testing::Values(OrientationForm{"quaternion", R"(quat="1 0 0 1")", "", "z 1/2*Pi"},
                      OrientationForm{"long_quaternion", R"(quat="0 3 0 0")", "", "x Pi"},
                      OrientationForm{"pitch", R"(quat="1 0 1 0")", "", "y 1/2*Pi"},
                      OrientationForm{"euler", R"(euler="30 0 90")", "", "x 1/6*Pi, z 1/2*Pi"},
                      OrientationForm{"euler_about_fixed_axes", R"(euler="30 0 90")", R"(<compiler eulerseq="XYZ"/>)",
                                      "z 1/2*Pi, x 1/6*Pi"},
                      OrientationForm{"axis_and_angle", R"(axisangle="0 -2 0 90")", "", "y -1/2*Pi"},
                      OrientationForm{"oblique_axis", R"(axisangle="1 1 1 120")", "", "z 1/2*Pi, x 1/2*Pi"},
                      OrientationForm{"two_axes", R"(xyaxes="0 1 0 -1 5 0")", "", "z 1/2*Pi"},
                      OrientationForm{"z_axis", R"(zaxis="0 -3 0")", "", "x 1/2*Pi"},
                      OrientationForm{"z_axis_down", R"(zaxis="0 0 -1")", "", "x Pi"}),
    [](const auto& tested) { return std::string(tested.param.name); });

TEST_F(MjcfReader, AddsWhatActuatorsReflect) {
  const Robot robot = mjcf(mjcf_body("a", R"(<joint name="j" armature="0.1" damping="1"/>)"), "",
                           R"(<actuator><motor joint="j" gear="3" armature="0.5" damping="0.25" ctrlrange="-2 2"
                              ctrllimited="true"/></actuator>)");
  EXPECT_EQ(printed_exactly(robot.joints[0].armature.number), "23/5");
  EXPECT_EQ(printed_exactly(robot.joints[0].viscous.number), "13/4");
  EXPECT_EQ(printed_exactly(robot.joints[0].limits.effort->number), "6");
}

TEST_F(MjcfReader, TakesTheSmallerOfTwoEffortLimits) {
  const Robot robot = mjcf(mjcf_body("a", R"(<joint name="j" actuatorfrcrange="-5 5"/>)"), "",
                           R"(<actuator><position joint="j" gear="2" forcerange="-2 2"/></actuator>)");
  EXPECT_EQ(printed_exactly(robot.joints[0].limits.effort->number), "4");
}

TEST_F(MjcfReader, CouplesJointsByALinearEquality) {
  const Robot robot = mjcf(
      mjcf_body("a", R"(<joint name="j" type="slide" ref="1"/>)") + mjcf_body("b", R"(<joint name="k" type="slide"/>)"),
      "", R"(<equality><joint joint1="j" joint2="k" polycoef="0.5 2 0 0 0"/></equality>)");
  const LinearPosition position = joint_positions(robot)[0];
  EXPECT_EQ(printed_exactly(position.offset), "3/2");
  EXPECT_EQ(printed_exactly(position.factors.at(1)), "2");
}

TEST_F(MjcfReader, HoldsAJointThatAnEqualityHolds) {
  const Robot robot = mjcf(mjcf_body("a", R"(<joint name="j" type="slide"/>)") + mjcf_body("b", R"(<joint name="k"/>)"),
                           "", R"(<equality><joint joint1="j" polycoef="0.5"/></equality>)");
  EXPECT_EQ(robot.joints[0].type, JointType::fixed);
  EXPECT_EQ(printed_exactly(robot.joints[0].held->position), "1/2");
}

TEST_F(MjcfReader, ClosesAChainByConnect) {
  const Robot robot =
      mjcf(mjcf_body("a", R"(<joint name="i"/>)" + mjcf_body("b", R"(<joint name="j"/>)", R"(pos="1 0 0")")) +
               mjcf_body("c", R"(<joint name="k"/>)", R"(pos="0 3 0")"),
           "", R"(<equality><connect body1="b" body2="c" anchor="0 2 0"/></equality>)");
  ASSERT_EQ(robot.loops.size(), 1U);
  EXPECT_EQ(robot.loops[0].links[1].name, "c");
  EXPECT_EQ(joints_named_by(robot.loops[0].dependent), (std::vector<std::string>{"j", "k"}));
}

// A joint that an actuator drives keeps its coordinate.
TEST_F(MjcfReader, JointsWithoutActuatorsFollow) {
  const std::string chain = mjcf_body("a", R"(<joint name="i"/>)" +
                                               mjcf_body("b", R"(<joint name="j"/>)", R"(pos="1 0 0")")) +
                            mjcf_body("c", R"(<joint name="k"/>)", R"(pos="0 3 0")"),
                    connect = R"(<equality><connect body1="b" body2="c" anchor="0 2 0"/></equality>)";
  const Robot driven = mjcf(chain, "", connect + R"(<actuator><motor joint="k"/></actuator>)");
  EXPECT_EQ(joints_named_by(driven.loops.at(0).dependent), (std::vector<std::string>{"i", "j"}));
  const Robot held_by_all =
      mjcf(chain, "", connect + R"(<actuator><motor joint="k"/><motor joint="j"/><motor joint="i"/></actuator>)");
  EXPECT_EQ(joints_named_by(held_by_all.loops.at(0).dependent), (std::vector<std::string>{"j", "k"}));
}

TEST_F(MjcfReader, WeldsABodyToTheWorld) {
  const Robot robot = mjcf(mjcf_body("a", R"(<joint name="j"/>)") + mjcf_body("b", R"(<joint name="k"/>)"), "",
                           R"(<equality><weld body1="a"/></equality>)");
  EXPECT_EQ(robot.joints[0].type, JointType::fixed);
}

TEST_F(MjcfReader, ReadsGravityAndItsAbsence) {
  EXPECT_EQ(printed_exactly(mjcf(mjcf_body("a", "<joint/>"), R"(<option gravity="0 0 -5"/>)").gravity[2]), "-5");
  EXPECT_EQ(
      printed_exactly(mjcf(mjcf_body("a", "<joint/>"), R"(<option><flag gravity="disable"/></option>)").gravity[2]),
      "0");
}

// The spring is relaxed at MuJoCo's q, which `ref` does not move; angles are in degrees.
TEST_F(MjcfReader, ReadsSprings) {
  const Robot robot = mjcf(mjcf_body("a", R"(<joint name="j" stiffness="5 0" springref="45" ref="10"/>)") +
                           mjcf_body("b", R"(<joint name="k" type="slide" stiffness="2" springref="45"/>)"));
  ASSERT_EQ(robot.joints.size(), 2U);
  EXPECT_TRUE(robot.joints[0].stiffness.number.is_equal(5));
  EXPECT_TRUE(robot.joints[0].spring_reference.number.is_equal(GiNaC::Pi / 4));
  EXPECT_TRUE(robot.joints[1].stiffness.number.is_equal(2));
  EXPECT_TRUE(robot.joints[1].spring_reference.number.is_equal(45));
}

TEST_F(MjcfReader, LeavesOutWhatIsIgnoredWithANote) {
  ReadOptions options;
  options.ignored = {"stiffness"};
  const Robot robot = mjcf(mjcf_body("a", R"(<joint name="j" stiffness="5"/>)"), "", "", options);
  EXPECT_EQ(robot.joints.size(), 1U);
  EXPECT_THAT(messages(), ElementsAre("stiffness: left out here, by --ignore"));
}

TEST_F(MjcfReader, IncludesFilesOnce) {
  write("arm.xml", "<mujocoinclude>" + mjcf_body("a", R"(<joint name="j"/>)") + "</mujocoinclude>");
  const Robot robot = mjcf(R"(<include file="arm.xml"/>)");
  EXPECT_THAT(joints_of(robot), ElementsAre("j"));
  EXPECT_EQ(robot.files.size(), 2U);
  EXPECT_EQ(std::filesystem::path(robot.joints[0].place.file).filename(), "arm.xml");
}

// Indices of links are those of the robot that is left.
TEST_F(MjcfReader, LeavesOutWhatStandsStillBesideAFloatingRobot) {
  ReadOptions options;
  options.scene.locked.push_back({"of box"});
  const Robot robot = mjcf(mjcf_body("table", mjcf_body("lamp", "")) +
                               mjcf_body("trunk", "<freejoint/>" + mjcf_body("leg", R"(<joint name="hip"/>)")) +
                               mjcf_body("box", R"(<freejoint name="of box"/>)"),
                           "", "", options);
  EXPECT_TRUE(robot.floating_base);
  EXPECT_THAT(joints_of(robot), ElementsAre("hip"));
  ASSERT_EQ(robot.links.size(), 2U);
  EXPECT_EQ(robot.links[static_cast<std::size_t>(robot.root)].name, "trunk");
  EXPECT_EQ(robot.links[static_cast<std::size_t>(robot.joints[0].child)].name, "leg");
}

// Makers of robots write such dummies beside them.
TEST_F(MjcfReader, LeavesOutJointsBesideAFloatingRobotThatAreHeld) {
  const std::string trunk =
      mjcf_body("trunk", "<freejoint name=\"root\"/>" + mjcf_body("leg", R"(<joint name="hip"/>)"));
  const std::string dummies =
      mjcf_body("dummy", R"(<joint name="spare"/>)" + mjcf_body("more", R"(<joint name="slide" type="slide"/>)"));
  ReadOptions options;
  for (const char* name : {"spare", "slide"}) options.scene.locked.push_back({name});
  const Robot robot = mjcf(dummies + trunk, "", "<actuator><motor joint=\"spare\"/></actuator>", options);
  EXPECT_FALSE(diagnostics_.has_errors());
  EXPECT_TRUE(robot.floating_base);
  EXPECT_THAT(joints_of(robot), ElementsAre("hip"));
  ASSERT_EQ(robot.links.size(), 2U);
}

TEST_F(MjcfReader, NamesAllJointsBesideAFloatingRobot) {
  const std::string bodies =
      mjcf_body("trunk", "<freejoint name=\"root\"/>") +
      mjcf_body("dummy", R"(<joint name="spare"/>)" + mjcf_body("more", R"(<joint name="slide" type="slide"/>)"));
  EXPECT_FALSE(read_robot(write("r.xml", "<mujoco><worldbody>" + bodies + "</worldbody></mujoco>"), {}, diagnostics_)
                   .has_value());
  ASSERT_FALSE(diagnostics_.all().empty());
  EXPECT_EQ(
      diagnostics_.all().front().message,
      "joint \"root\" moves freely, but does not carry all that moves: joints \"spare\", \"slide\" are beside it");
  EXPECT_EQ(diagnostics_.all().front().hint,
            "hold what is beside it still, which leaves it out: --fix spare --fix slide; or this joint: --fix root");
}

// Defaults that are meant for other joints count, too. <freejoint/> takes none.
TEST_F(MjcfReader, ReadsArmatureAndFrictionOfAFreeJoint) {
  const std::string defaults = R"(<default><joint armature="0.1" damping="0.5" frictionloss="2"/></default>)";
  const Robot robot = mjcf(mjcf_body("trunk", R"(<joint name="root" type="free" damping="3 0"/>)"), defaults);
  EXPECT_TRUE(robot.floating_base);
  EXPECT_EQ(printed_exactly(robot.base_joint.armature.number), "1/10");
  EXPECT_EQ(printed_exactly(robot.base_joint.viscous.number), "3");
  EXPECT_EQ(printed_exactly(robot.base_joint.coulomb.number), "2");
  EXPECT_THAT(
      messages(),
      ElementsAre("joint \"root\" moves freely with armature, damping, frictionloss, perhaps by accident",
                  "joint \"root\", frictionloss: left out along the axes of the world, read about those of the base"));
  const Robot plain = mjcf(mjcf_body("trunk", "<freejoint/>"), defaults);
  EXPECT_TRUE(plain.base_joint.armature.number.is_zero());
}

TEST_F(MjcfReader, ReadsNoForcesOfAFreeJointThatIsHeld) {
  ReadOptions options;
  options.floating_base = false;
  const Robot robot = mjcf(mjcf_body("trunk", R"(<joint name="root" type="free" damping="3" stiffness="2"/>)" +
                                                  mjcf_body("leg", R"(<joint name="hip"/>)")),
                           "", "", options);
  EXPECT_FALSE(robot.floating_base);
  EXPECT_TRUE(robot.base_joint.viscous.number.is_zero());
  EXPECT_THAT(messages(), ElementsAre());
}

// As MuJoCo does: in the main file's folder first, then beside the file that includes it.
TEST_F(MjcfReader, IncludesFilesBesideTheOneThatNamesThem) {
  std::filesystem::create_directories(folder_ / "parts");
  write("parts/arm.xml", R"(<mujocoinclude><include file="hand.xml"/><include file="foot.xml"/></mujocoinclude>)");
  write("parts/hand.xml", "<mujocoinclude>" + mjcf_body("a", R"(<joint name="beside"/>)") + "</mujocoinclude>");
  write("parts/foot.xml", "<mujocoinclude>" + mjcf_body("b", R"(<joint name="not this"/>)") + "</mujocoinclude>");
  write("foot.xml", "<mujocoinclude>" + mjcf_body("b", R"(<joint name="in the main folder"/>)") + "</mujocoinclude>");
  EXPECT_THAT(joints_of(mjcf(R"(<include file="parts/arm.xml"/>)")), ElementsAre("beside", "in the main folder"));
}

TEST_F(MjcfReader, NamesWhatHasNoName) {
  const Robot robot =
      mjcf("<body>" + std::string(kBodyOfTwoKilograms) + "<joint/><body>" + kBodyOfTwoKilograms + "</body></body>");
  EXPECT_THAT(joints_of(robot), ElementsAre("body1_joint", "body2"));
}

}  // namespace
}  // namespace flatdyn
