// SPDX-License-Identifier: GPL-2.0-or-later
// Frames, nested models, worlds and included files.
#include <gtest/gtest.h>

#include "unit/input/robot_file.hpp"
#include "unit/input/sdf/sdf_text.hpp"

namespace flatdyn {
namespace {

class SdfFrames : public RobotFiles {
 protected:
  // The translations of a joint's origin: its frames are not turned.
  static Vec3 place_of(const Joint& joint) {
    Vec3 sum = zero_vector();
    for (const Displacement& each : joint.origin.displacements) {
      EXPECT_EQ(each.kind, Displacement::Kind::translation);
      sum = sum + each.translation;
    }
    return sum;
  }
  static const Joint& joint_called(const Robot& robot, const std::string& name) {
    for (const Joint& joint : robot.joints) {
      if (joint.name == name) return joint;
    }
    throw std::runtime_error("no joint " + name);
  }
};

TEST_F(SdfFrames, FollowsRelativeTo) {
  const Robot robot = read("r.sdf", sdf_model(R"(
    <link name="base"/>
    <frame name="mount" attached_to="base"><pose>0 0 2 0 0 0</pose></frame>
    <joint name="j" type="revolute"><pose relative_to="mount">0 1 0 0 0 0</pose>
      <parent>mount</parent><child>arm</child><axis><xyz>0 0 1</xyz></axis></joint>
    <link name="arm"><pose relative_to="j">0 0 0 0 0 0</pose></link>)"));
  const Vec3 place = place_of(robot.joints.at(0));
  EXPECT_TRUE(place[1].is_equal(1));
  EXPECT_TRUE(place[2].is_equal(2));
  EXPECT_TRUE(robot.joints.at(0).link_offset.displacements.empty());
  EXPECT_EQ(robot.links.at(static_cast<std::size_t>(robot.joints.at(0).parent)).name, "base");
}

constexpr const char* kNested = R"(
  <link name="base"/>
  <model name="hand" placement_frame="wrist">
    <pose relative_to="base">0 0 1 0 0 0</pose>
    <link name="palm"><pose>0 0 0.25 0 0 0</pose></link>
    <frame name="wrist" attached_to="palm"><pose>0 0 -0.125 0 0 0</pose></frame>
    <link name="finger"/>
    <joint name="bend" type="revolute"><parent>palm</parent><child>finger</child><axis><xyz>0 0 1</xyz></axis></joint>
  </model>
  <joint name="turn" type="revolute"><parent>base</parent><child>hand::palm</child>
    <axis><xyz>0 0 1</xyz></axis></joint>)";

TEST_F(SdfFrames, ReadsNestedModelsByTheirPlacementFrame) {
  const Robot robot = read("r.sdf", sdf_model(kNested));
  EXPECT_EQ(robot.links.at(1).name, "hand::palm");
  // The wrist is at 1, and the palm 0.125 above it.
  EXPECT_TRUE(place_of(joint_called(robot, "turn"))[2].is_equal(Number(9) / 8));
  EXPECT_TRUE(place_of(joint_called(robot, "hand::bend"))[2].is_equal(Number(-1) / 4));
}

TEST_F(SdfFrames, TakesTheCanonicalLinkForTheModel) {
  const Robot robot = read("r.sdf", sdf_model(R"(<link name="base"/>
    <model name="hand" canonical_link="b"><link name="a"/><link name="b"/>
      <joint name="k" type="fixed"><parent>a</parent><child>b</child></joint></model>
    <joint name="j" type="revolute"><parent>hand</parent><child>base</child><axis><xyz>0 0 1</xyz></axis></joint>)"));
  EXPECT_EQ(robot.links.at(static_cast<std::size_t>(joint_called(robot, "j").parent)).name, "hand::b");
}

TEST_F(SdfFrames, ReadsAWorld) {
  const std::string world = R"(<sdf version="1.9"><world name="w"><gravity>0 0 -1.62</gravity>
    <model name="ground"><static>true</static><link name="plane"/></model>
    <model name="r"><link name="base"/><link name="arm"/>
      <joint name="stand" type="fixed"><parent>world</parent><child>base</child></joint>)" +
                            sdf_joint("revolute", kAxisZ) + "</model></world></sdf>";
  const Robot robot = read("r.world", world);
  EXPECT_TRUE(robot.gravity[2].is_equal(Number(-162) / 100));
  EXPECT_EQ(robot.links.at(static_cast<std::size_t>(robot.root)).name, "world");
  EXPECT_EQ(robot.links.size(), 3U);
  const std::string without = world.substr(0, world.find("<gravity>")) + world.substr(world.find("<model"));
  EXPECT_TRUE(read("r.world", without).gravity[2].is_equal(Number(-98) / 10));
}

TEST_F(SdfFrames, ReadsTheModelThatIsAskedFor) {
  ReadOptions options;
  options.model = "b";
  const std::string model = kBaseAndArm + sdf_joint("revolute", kAxisZ) + "</model>";
  const std::string text =
      "<sdf version=\"1.6\"><world name=\"w\"><include><uri>model://sun</uri></include>"
      "<model name=\"a\">" +
      model + "<model name=\"b\">" + model + "</world></sdf>";
  EXPECT_EQ(read("r.sdf", text, options).name, "b");
}

TEST_F(SdfFrames, IncludesModelsOfFolders) {
  std::filesystem::create_directories(folder_ / "gripper");
  write("gripper/model.config", R"(<model><sdf version="1.5">old.sdf</sdf><sdf version="1.9">new.sdf</sdf></model>)");
  write("gripper/new.sdf", sdf_model(R"(<link name="palm"/><link name="finger"/>
    <joint name="bend" type="revolute"><parent>palm</parent><child>finger</child>
      <axis><xyz>0 0 1</xyz></axis></joint>)"));
  for (const char* uri : {"gripper", "model://gripper", "gripper/new.sdf"}) {
    const Robot robot = read("r.sdf", sdf_model(R"(<link name="base"/>
      <include><uri>)" + std::string(uri) + R"(</uri><name>left</name><pose>0 0 3 0 0 0</pose></include>
      <joint name="j" type="revolute"><parent>base</parent><child>left::palm</child>
        <axis><xyz>0 0 1</xyz></axis></joint>)"));
    EXPECT_TRUE(place_of(joint_called(robot, "j"))[2].is_equal(3)) << uri;
    EXPECT_EQ(joint_called(robot, "left::bend").type, JointType::revolute);
    EXPECT_EQ(robot.files.size(), 2U);
  }
}

TEST_F(SdfFrames, MergesAnIncludedModel) {
  write("hand.sdf", sdf_model(R"(<link name="palm"/><frame name="f" attached_to="__model__"/>)"));
  const Robot robot = read("r.sdf", sdf_model(R"(<link name="base"/>
    <include merge="true"><uri>hand.sdf</uri><pose>0 0 3 0 0 0</pose></include>
    <joint name="j" type="revolute"><parent>base</parent><child>f</child><axis><xyz>0 0 1</xyz></axis></joint>)"));
  EXPECT_EQ(robot.links.at(1).name, "palm");
  EXPECT_TRUE(place_of(robot.joints.at(0))[2].is_equal(3));
}

TEST_F(SdfFrames, FixesStaticModelsToTheWorld) {
  const Robot robot = read("r.sdf", sdf_model(R"(<link name="base"/>
    <model name="table"><static>true</static><link name="top"><pose>0 0 1 0 0 0</pose></link></model>
    <joint name="j" type="revolute"><parent>table::top</parent><child>base</child>
      <axis><xyz>0 0 1</xyz></axis></joint>)"));
  EXPECT_EQ(robot.links.at(static_cast<std::size_t>(robot.root)).name, "world");
  EXPECT_EQ(joint_called(robot, "world to table::top").type, JointType::fixed);
}

TEST_F(SdfFrames, StandUnderATomlFile) {
  write("r.sdf", sdf_model(kBaseAndArm + sdf_joint("revolute", kAxisZ)));
  const Robot robot = read("r.toml", "robot = \"r.sdf\"\n[[joint]]\nname = \"j\"\nviscous = 0.5\n");
  EXPECT_TRUE(robot.joints.at(0).viscous.number.is_equal(Number(1) / 2));
}

}  // namespace
}  // namespace flatdyn
