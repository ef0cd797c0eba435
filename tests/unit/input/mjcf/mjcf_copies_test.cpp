// SPDX-License-Identifier: GPL-2.0-or-later
// Copies of elements and attached models in MJCF files, and keyframes. tests/differential compares them with MuJoCo.
#include <gmock/gmock.h>

#include "unit/input/robot_file.hpp"

namespace flatdyn {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class MjcfCopies : public RobotFiles {
 protected:
  // The first error of a file that has one.
  std::string error_of(const std::string& text, const ReadOptions& options = {}) {
    diagnostics_ = {};
    read_robot(write("r.xml", text), options, diagnostics_);
    for (const Diagnostic& found : diagnostics_.all()) {
      if (found.severity == Severity::error) return to_string(found);
    }
    return "";
  }
};

std::vector<std::string> moving_joints_of(const Robot& robot) {
  std::vector<std::string> names;
  for (const Joint& joint : robot.joints) {
    if (joint.type != JointType::fixed) names.push_back(joint.name);
  }
  return names;
}

std::string in_world(const std::string& bodies, const std::string& more = "") {
  return "<mujoco><worldbody>" + bodies + "</worldbody>" + more + "</mujoco>";
}

constexpr const char* kLeg = R"(<body name="leg" pos="0 1 0"><joint name="hip"/><geom size="1" mass="2"/></body>)";

std::string legs(const std::string& attributes) { return "<replicate " + attributes + ">" + kLeg + "</replicate>"; }

TEST_F(MjcfCopies, AreNumberedWithAsManyDigitsAsTheirCountHas) {
  const Robot robot = read("r.xml", in_world(legs(R"(count="10" offset="1 0 0" sep="_")")));
  const std::vector<std::string> joints = moving_joints_of(robot);
  ASSERT_EQ(joints.size(), 10U);
  EXPECT_EQ(joints.front(), "hip_00");
  EXPECT_EQ(joints.back(), "hip_09");
  EXPECT_EQ(robot.links.back().name, "leg_09");
}

TEST_F(MjcfCopies, AreMovedByWhatMovesTheOriginal) {
  const Robot robot = read(
      "r.xml", in_world(legs(R"(count="2")"), R"(<actuator><motor joint="hip" armature="3" gear="2"/></actuator>)"));
  for (const Joint& joint : robot.joints) EXPECT_EQ(nearest_double(joint.armature.number), 12) << joint.name;
}

TEST_F(MjcfCopies, CannotBeTiedToWhatIsNoCopy) {
  const std::string text = in_world(legs(R"(count="2")") + R"(<body><joint name="other"/><geom size="1"/></body>)",
                                    R"(<equality><joint joint1="hip" joint2="other"/></equality>)");
  EXPECT_THAT(error_of(text), HasSubstr("equality, joint acts on what is replicated and on what is not"));
}

TEST_F(MjcfCopies, AreCounted) {
  EXPECT_THAT(error_of(in_world(legs(R"(count="two")"))), HasSubstr("\"two\" is not a number of copies"));
  EXPECT_THAT(error_of(in_world(legs(""))), HasSubstr("<replicate> has no count"));
  const std::string many = R"(<replicate count="9000" sep="-">)" + legs(R"(count="9000")") + "</replicate>";
  EXPECT_THAT(error_of(in_world(many)), HasSubstr("more than 10000 elements"));
}

class MjcfAttached : public MjcfCopies {
 protected:
  // A file that attaches arm.xml.
  static std::string attaching(const std::string& attributes, const std::string& before = "") {
    return "<mujoco>" + before + R"(<asset><model name="arm" file="arm.xml"/></asset><worldbody><attach )" +
           attributes + "/></worldbody></mujoco>";
  }

  void write_arm(const std::string& before = "") const {
    write("arm.xml", "<mujoco>" + before + R"(<default><joint damping="2"/></default><worldbody>)" + kLeg +
                         R"(<body name="b"><joint name="k"/><geom size="1"/></body></worldbody></mujoco>)");
  }
};

TEST_F(MjcfAttached, HaveNamesWithAPrefixAndDefaultsOfTheirOwn) {
  write_arm();
  const Robot robot =
      read("r.xml", attaching(R"(model="arm" prefix="left/")", R"(<default><joint damping="7"/></default>)"));
  EXPECT_THAT(moving_joints_of(robot), ElementsAre("left/hip", "left/k"));
  EXPECT_EQ(nearest_double(robot.joints[0].viscous.number), 2);
  EXPECT_EQ(robot.files.back(), (folder_ / "arm.xml").string());
}

TEST_F(MjcfAttached, CanBeABodyAlone) {
  write_arm();
  EXPECT_THAT(moving_joints_of(read("r.xml", attaching(R"(model="arm" body="leg" prefix="l_")"))),
              ElementsAre("l_hip"));
}

TEST_F(MjcfAttached, MustBeThereAndHaveTheSameSettings) {
  EXPECT_THAT(error_of(attaching(R"(model="arm" prefix="l")")), HasSubstr("there is no file"));
  write_arm();
  EXPECT_THAT(error_of(attaching(R"(model="leg" prefix="l")")), HasSubstr("there is no model \"leg\""));
  EXPECT_THAT(error_of(attaching(R"(model="arm" body="x" prefix="l")")), HasSubstr("the model has no body \"x\""));
  EXPECT_THAT(error_of(attaching(R"(model="arm")")), HasSubstr("<attach> has no prefix"));
  EXPECT_THAT(error_of(attaching(R"(body="arm" prefix="l")")), HasSubstr("a part of the model itself"));
  write_arm(R"(<compiler angle="radian"/>)");
  EXPECT_THAT(error_of(attaching(R"(model="arm" prefix="l")")), HasSubstr("has another angle than this file's"));
}

TEST_F(MjcfAttached, CannotAttachThemselves) {
  write("arm.xml", attaching(R"(model="arm" prefix="l")"));
  EXPECT_THAT(error_of(attaching(R"(model="arm" prefix="l")")), HasSubstr("a model cannot attach itself"));
}

constexpr const char* kClosedChain = R"(<mujoco><worldbody>
  <body name="a"><freejoint name="f"/><geom size="1"/></body>
  <body name="b"><joint name="j" ref="10"/><geom size="1"/><body name="c" pos="1 0 0"><joint name="k"/><geom size="1"/>
    <body name="d" pos="1 0 0"><joint name="l"/><geom size="1"/></body></body></body></worldbody>
  <equality><connect body1="d" anchor="1 0 0"/></equality>
  <keyframe><key name="home" qpos="0 0 0 1 0 0 0 .25 .5 .75"/><key name="short" qpos="1 2"/></keyframe></mujoco>)";

ReadOptions at_keyframe(const std::string& name) {
  ReadOptions options;
  options.keyframe = name;
  options.scene.locked.push_back({"f"});
  return options;
}

TEST_F(MjcfCopies, TakesTheAssemblyFromAKeyframe) {
  const Robot robot = read("r.xml", kClosedChain, at_keyframe("home"));
  std::vector<std::string> found;
  for (const JointPosition& each : robot.assembly) {
    found.push_back(each.joint + " " + to_decimal(each.position, 5));
  }
  EXPECT_THAT(found, ElementsAre("j 0.25", "k 0.5", "l 0.75"));
}

// The free joint is left out of the robot; its seven numbers stay those of the base.
TEST_F(MjcfCopies, TakesTheAssemblyOfAFloatingRobotFromAKeyframe) {
  ReadOptions options;
  options.keyframe = "home";
  const Robot robot = read("r.xml", R"(<mujoco><compiler angle="radian"/><worldbody>
  <body name="a"><freejoint name="f"/><geom size="1"/>
    <body name="b"><joint name="j"/><geom size="1"/><body name="c" pos="1 0 0"><joint name="k"/><geom size="1"/>
      <body name="d" pos="1 0 0"><joint name="l"/><geom size="1"/></body></body></body></body></worldbody>
  <equality><connect body1="d" body2="a" anchor="1 0 0"/></equality>
  <keyframe><key name="home" qpos="9 8 7 1 0 0 0 .25 .5 .75"/></keyframe></mujoco>)",
                           options);
  EXPECT_TRUE(robot.floating_base);
  std::vector<std::string> found;
  for (const JointPosition& each : robot.assembly) found.push_back(each.joint + " " + to_decimal(each.position, 5));
  EXPECT_THAT(found, ElementsAre("j 0.25", "k 0.5", "l 0.75"));
}

// As in MuJoCo, what is not of the attached model stays where `ref` puts it.
TEST_F(MjcfCopies, TakesTheAssemblyFromAKeyframeOfAnAttachedModel) {
  write("chain.xml", R"(<mujoco model="chain"><compiler angle="radian"/><worldbody>
  <body name="b"><joint name="j"/><geom size="1"/><body name="c" pos="1 0 0"><joint name="k"/><geom size="1"/>
    <body name="d" pos="1 0 0"><joint name="l"/><geom size="1"/></body></body></body></worldbody>
  <equality><connect body1="d" anchor="1 0 0"/></equality>
  <keyframe><key name="home" qpos=".25 .5 .75"/></keyframe></mujoco>)");
  ReadOptions options;
  options.keyframe = "x_home";
  const Robot robot = read("r.xml", R"(<mujoco><compiler angle="radian"/><asset><model file="chain.xml"/></asset>
      <worldbody><body><joint name="h" ref=".125"/><geom size="1"/></body>
        <attach model="chain" prefix="x_"/></worldbody></mujoco>)",
                           options);
  std::vector<std::string> found;
  for (const JointPosition& each : robot.assembly) found.push_back(each.joint + " " + to_decimal(each.position, 5));
  EXPECT_THAT(found, ElementsAre("h 0.125", "x_j 0.25", "x_k 0.5", "x_l 0.75"));
}

TEST_F(MjcfCopies, NeedsAKeyframeWithAllPositions) {
  EXPECT_THAT(error_of(kClosedChain, at_keyframe("hoem")), HasSubstr("there is no keyframe \"hoem\""));
  EXPECT_THAT(error_of(kClosedChain, at_keyframe("short")), HasSubstr("10 numbers are expected"));
}

}  // namespace
}  // namespace flatdyn
