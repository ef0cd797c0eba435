// SPDX-License-Identifier: GPL-2.0-or-later
// Closed chains, gears and mimicking joints in the dialects of URDF, against the same robots as URDF or TOML says them.
#include <gmock/gmock.h>

#include <cmath>

#include "flatdyn/reference/newton_euler.hpp"
#include "robot/model/coupling.hpp"
#include "robot/model/mechanism.hpp"
#include "truth/reference/reference_model.hpp"
#include "unit/input/robot_file.hpp"

namespace flatdyn {
namespace {

using ::testing::ElementsAre;

class UrdfLoops : public RobotFiles {};

std::string link(const std::string& name) {
  return "<link name=\"" + name +
         "\"><inertial><origin xyz=\"0.1 0.02 0\"/><mass value=\"1\"/><inertia ixx=\"0.01\" iyy=\"0.02\" izz=\"0.02\" "
         "ixy=\"0.001\" ixz=\"0\" iyz=\"0\"/></inertial></link>";
}

struct Placed {
  std::string parent, child, xyz = "0 0 0", axis = "0 0 1", more = "";
};

std::string joint(const std::string& name, const Placed& placed,
                  const std::string& attributes = "type=\"continuous\"") {
  return "<joint name=\"" + name + "\" " + attributes + "><parent link=\"" + placed.parent + "\"/><child link=\"" +
         placed.child + "\"/><origin xyz=\"" + placed.xyz + "\"/><axis xyz=\"" + placed.axis + "\"/>" + placed.more +
         "</joint>";
}

std::string robot(const std::string& elements) {
  return "<robot name=\"r\"><link name=\"base\"/>" + elements + "</robot>";
}

constexpr const char* kDependent = "type=\"continuous\" independent=\"false\"";

// --- joints that follow one other ---

std::string arm_and_hand(const std::string& mimic, const std::string& more) {
  return robot(link("arm") + link("hand") + joint("j", {"base", "arm"}) +
               joint("k", {"arm", "hand", "0.3 0 0", "1 0 0", mimic}) + more);
}

struct LoopDialect {
  const char* name;
  const char* text;
};

class MimicDialects : public RobotFiles, public ::testing::WithParamInterface<LoopDialect> {};

TEST_P(MimicDialects, SayWhatMimicSays) {
  const Robot wanted = read("m.urdf", arm_and_hand(R"(<mimic joint="j" multiplier="-2" offset="0.1"/>)", ""));
  const Robot found = read("r.urdf", arm_and_hand("", GetParam().text));
  const LinearPosition a = joint_positions(wanted)[1], b = joint_positions(found)[1];
  EXPECT_EQ(b.factors.at(0), Number(-2));
  EXPECT_EQ(b.factors.at(0), a.factors.at(0));
  EXPECT_EQ(b.offset, a.offset);
  EXPECT_EQ(make_mechanism(found).size(), 1);
}

const LoopDialect kDialects[] = {
    {"Gazebo", R"(<gazebo><plugin name="grip" filename="libroboticsgroup_gazebo_mimic_joint_plugin.so"><joint>j</joint>
      <mimicJoint> k </mimicJoint><multiplier>-2</multiplier><offset>0.1</offset><maxEffort>5</maxEffort></plugin></gazebo>)"},
    {"Care_O_bot", R"(<gazebo><plugin name="m"><jointName>j</jointName><mimicJoint>k</mimicJoint>
      <multiplier>-2.0</multiplier><offset>0.1</offset></plugin></gazebo>)"},
    {"ros2_control",
     R"(<ros2_control name="s" type="system"><joint name="j"/><joint name="k"><param name="mimic">j</param>
      <param name="multiplier">-2</param><param name="offset">0.1</param></joint></ros2_control>)"},
    {"MuJoCo", R"(<mujoco><equality><joint joint1="k" joint2="j" polycoef="0.1 -2 0 0 0"/></equality></mujoco>)"},
};

INSTANTIATE_TEST_SUITE_P(All, MimicDialects, ::testing::ValuesIn(kDialects),
                         [](const ::testing::TestParamInfo<LoopDialect>& dialect) {
                           return std::string(dialect.param.name);
                         });

TEST_F(UrdfLoops, MimicsThatAgreeAreOne) {
  std::string all;
  for (const LoopDialect& dialect : kDialects) all += dialect.text;
  const Robot found = read("r.urdf", arm_and_hand(R"(<mimic joint="j" multiplier="-2.00" offset="0.1"/>)", all));
  EXPECT_EQ(make_mechanism(found).size(), 1);
}

TEST_F(UrdfLoops, EqualitiesThatAreNotActiveSayNothing) {
  const char* text =
      R"(<mujoco><equality><joint joint1="k" joint2="j" active="false"/><weld body1="arm" active="false"/>
      </equality></mujoco>)";
  EXPECT_EQ(make_mechanism(read("r.urdf", arm_and_hand("", text))).size(), 2);
}

// --- gears ---

std::string coupling(const std::string& predecessor, const std::string& successor, const std::string& ratio) {
  return "<coupling name=\"c\"><predecessor link=\"" + predecessor + "\"/><successor link=\"" + successor +
         "\"/><ratio value=\"" + ratio + "\"/></coupling>";
}

// 0.05 + 6² · 1e-4 kg m², with the arm's 1 kg at 0.2 m and its 0.01 kg m².
TEST_F(UrdfLoops, AGearedRotorCountsByTheSquareOfItsRatio) {
  const std::string inertia = "<inertia ixx=\"1e-4\" iyy=\"1e-4\" izz=\"1e-4\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/>";
  const std::string gear = robot(
      R"(<link name="arm"><inertial><origin xyz="0.2 0 0"/><mass value="1"/><inertia ixx="0.01" iyy="0.01" izz="0.01"/>
      </inertial></link><link name="rotor"><inertial><mass value="0.1"/>)" +
      inertia + "</inertial></link>" + joint("shoulder", {"base", "arm"}, "type=\"continuous\" independent=\"True\"") +
      joint("spin", {"base", "rotor"}, "type=\"continuous\" independent=\"False\"") + coupling("arm", "rotor", "6"));
  const Robot found = read("gear.urdf", gear);
  EXPECT_TRUE(diagnostics_.all().empty());
  const auto numbers = reference_robot<double>(found, {});
  ASSERT_EQ(numbers.size(), 1);
  EXPECT_NEAR(reference::inertia_matrix<double>(numbers, Eigen::VectorXd::Zero(1))(0, 0), 0.0536, 1e-15);
}

// Towards the successor as much as the ratio times towards the predecessor, of all joints below what carries both: a
// tendon over two joints, and one over the first of them.
TEST_F(UrdfLoops, CouplingsAreSolvedTogether) {
  const std::string tree = link("m") + link("n") + link("a") + link("b") + joint("m", {"base", "m"}) +
                           joint("n", {"base", "n"}) + joint("a", {"base", "a"}, kDependent) +
                           joint("b", {"a", "b", "0.3 0 0"}, kDependent);
  const Robot found = read("r.urdf", robot(tree + coupling("m", "b", "2") + coupling("n", "a", "-3")));
  const std::vector<LinearPosition> positions = joint_positions(found);
  EXPECT_EQ(positions[2].factors, (std::map<int, Number>{{1, -3}}));
  EXPECT_EQ(positions[3].factors, (std::map<int, Number>{{0, 2}, {1, 3}}));
}

TEST_F(UrdfLoops, ACouplingMayStandInTheWordsThatItHadBefore) {
  const std::string text =
      robot(link("a") + link("r") + joint("a", {"base", "a"}) + joint("r", {"base", "r"}, kDependent) +
            R"(<joint_constraint name="t"><parent link="a"/><child link="r"/><gear_ratio value="6.0"/>
                                 </joint_constraint>)");
  EXPECT_EQ(joint_positions(read("r.urdf", text))[1].factors, (std::map<int, Number>{{0, 6}}));
}

TEST_F(UrdfLoops, TheOtherJointOfAGearMayFollow) {
  const std::string text = robot(link("a") + link("r") + joint("a", {"base", "a"}, kDependent) +
                                 joint("r", {"base", "r"}) + coupling("a", "r", "6"));
  EXPECT_EQ(joint_positions(read("r.urdf", text))[0].factors, (std::map<int, Number>{{1, Number(1) / 6}}));
}

TEST_F(UrdfLoops, WhoHoldsTheLeaderHoldsTheFollower) {
  ReadOptions options;
  options.scene.locked = {{"a", Number(1) / 2, "0.5", true, {}}};
  const std::string text =
      robot(link("a") + link("r") + link("b") + joint("a", {"base", "a"}) + joint("r", {"base", "r"}, kDependent) +
            joint("b", {"a", "b"}) + coupling("a", "r", "6"));
  const Robot found = read("r.urdf", text, options);
  EXPECT_EQ(make_mechanism(found).size(), 1);
  ASSERT_TRUE(found.joints[1].held.has_value());
  EXPECT_EQ(found.joints[1].held->position, Number(3));
}

// --- closed chains ---

std::string end(const std::string& tag, const std::string& name, const std::string& origin) {
  return "<" + tag + " link=\"" + name + "\"><origin " + origin + "/></" + tag + ">";
}

// A parallelogram with cranks of 0.2 m, 0.4 m apart; at 60° its links weigh (0.1 + 2 · 0.2 + 0.1) · 9.81 · cos 60°.
TEST_F(UrdfLoops, AParallelogramHasOneCoordinate) {
  const auto bar = [](const std::string& name, const std::string& centre, const std::string& mass) {
    return "<link name=\"" + name + "\"><inertial><origin xyz=\"" + centre + " 0 0\"/><mass value=\"" + mass +
           "\"/><inertia ixx=\"0\" iyy=\"0.004\" izz=\"0.004\"/></inertial></link>";
  };
  const std::string text =
      robot(bar("crank", "0.1", "1") + bar("coupler", "0.2", "2") + bar("rocker", "0.1", "1") +
            joint("A", {"base", "crank", "0 0 0", "0 -1 0"}) + joint("B", {"crank", "coupler", "0.2 0 0", "0 -1 0"}) +
            joint("D", {"base", "rocker", "0.4 0 0", "0 -1 0"}) +
            R"(<constraint name="C" type="revolute"><parent link="coupler"/><parent_origin xyz="0.4 0 0"/>
      <parent_axis xyz="0 -1 0"/><child link="rocker"/><child_origin xyz="0.2 0 0"/><child_axis xyz="0 1 0"/></constraint>)");
  const auto numbers = reference_robot<double>(read("bars.urdf", text), {});
  ASSERT_EQ(numbers.size(), 1);
  const Eigen::VectorXd q = Eigen::VectorXd::Constant(1, std::acos(-1) / 3), zero = Eigen::VectorXd::Zero(1);
  EXPECT_NEAR(reference::inverse_dynamics<double>(numbers, q, zero, zero)(0), 2.943, 1e-14);
}

// Dependent joints, by name.
std::vector<std::string> dependent_of(const Mechanism& mechanism, std::size_t loop) {
  std::vector<std::string> names;
  for (const int k : mechanism.loops[loop].dependent) names.push_back(mechanism.joint_at(k).joint);
  return names;
}

std::string four_bar(const std::string& closing, const std::string& crank = "type=\"continuous\"") {
  return robot(link("crank") + link("coupler") + link("rocker") + joint("A", {"base", "crank", "0 0 0.1"}, crank) +
               joint("B", {"crank", "coupler", "0.3 0 0"}, kDependent) +
               joint("C", {"base", "rocker", "0.5 0.05 0.1"}, kDependent) + closing);
}

constexpr const char* kFourBarToml = R"(name = "r"
[[link]]
name = "crank"
joint = "A"
xyz = [0, 0, 0.1]
mass = 1
[[link]]
name = "coupler"
joint = "B"
xyz = [0.3, 0, 0]
mass = 1
[[link]]
name = "rocker"
joint = "C"
parent = "base"
xyz = [0.5, 0.05, 0.1]
mass = 1
[[loop]]
links = ["coupler", "rocker"]
from = [0.6, 0.1, 0]
to = [0.4, 0, 0]
dependent = ["B", "C"]
)";

void expect_same_loop(const LoopClosure& a, const LoopClosure& b) {
  EXPECT_EQ(a.rows, b.rows);
  EXPECT_EQ(a.dependent, b.dependent);
  EXPECT_EQ(a.carrier, b.carrier);
  for (std::size_t e = 0; e < 2; ++e) {
    EXPECT_EQ(a.ends[e].body, b.ends[e].body);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_TRUE(vanishes(a.ends[e].p[i] - b.ends[e].p[i])) << e << " " << i;
  }
}

// The axis may be written in frames that are turned about it; the words are those of URDF+, or those it had before.
TEST_F(UrdfLoops, ALoopIsThatOfToml) {
  const Mechanism wanted = make_mechanism(read("m.toml", kFourBarToml));
  const std::string ends = end("predecessor", "coupler", "xyz=\"0.6 0.1 0\" rpy=\"0 0 0.3\"") +
                           end("successor", "rocker", "xyz=\"0.4 0 0\" rpy=\"0 0 -1.1\"");
  for (const std::string& closing :
       {"<loop name=\"D\" type=\"revolute\">" + ends + "<axis xyz=\"0 0 2\"/></loop>",
        "<loop name=\"D\" type=\"ball\">" + ends + "</loop>", "<constraint type=\"position\">" + ends + "</constraint>",
        std::string(R"(<loop_constraint name="D"><parent link="coupler"/><parent_origin xyz="0.6 0.1 0"/>
        <child link="rocker"/><child_origin xyz="0.4 0 0"/></loop_constraint>)")}) {
    const Mechanism found = make_mechanism(read("r.urdf", four_bar(closing)));
    EXPECT_TRUE(diagnostics_.all().empty()) << to_string(diagnostics_.all().front());
    ASSERT_EQ(found.loops.size(), 1U);
    expect_same_loop(found.loops[0], wanted.loops[0]);
  }
}

// The bodies of MuJoCo's <connect> meet where the model starts: at zero the coupler's end is at 0.9, 0.1, 0.1.
TEST_F(UrdfLoops, AConnectMeetsWhereTheJointsAreAtZero) {
  std::string toml = kFourBarToml;
  toml.replace(toml.find("to = [0.4, 0, 0]"), 16, "to = [0.4, 0.05, 0]");
  const Mechanism wanted = make_mechanism(read("m.toml", toml));
  const char* text =
      R"(<mujoco><equality><connect body1="coupler" body2="rocker" anchor="0.6 0.1 0"/></equality></mujoco>)";
  const Mechanism found = make_mechanism(read("r.urdf", four_bar(text)));
  ASSERT_EQ(found.loops.size(), 1U);
  expect_same_loop(found.loops[0], wanted.loops[0]);
}

TEST_F(UrdfLoops, EachLoopTakesTheMarkedJointsThatItDetermines) {
  const std::string text =
      four_bar("<loop name=\"D\" type=\"spherical\">" + end("predecessor", "coupler", "xyz=\"0.6 0.1 0\"") +
               end("successor", "rocker", "xyz=\"0.4 0 0\"") + "</loop>" + link("rod") + link("lever") +
               joint("E", {"rocker", "rod", "0.2 0.1 0"}, kDependent) +
               joint("F", {"base", "lever", "0.9 0 0.1"}, kDependent) + "<loop name=\"G\" type=\"spherical\">" +
               end("predecessor", "rod", "xyz=\"0.4 0 0\"") + end("successor", "lever", "xyz=\"0.3 0 0\"") + "</loop>");
  const Mechanism found = make_mechanism(read("r.urdf", text));
  ASSERT_EQ(found.loops.size(), 2U);
  EXPECT_THAT(dependent_of(found, 0), ElementsAre("B", "C"));
  EXPECT_THAT(dependent_of(found, 1), ElementsAre("E", "F"));
}

// A joint that both loops have drives them, where nothing is marked.
TEST_F(UrdfLoops, WithoutMarksTheFirstJointDrives) {
  const std::string bars = link("crank") + link("coupler") + link("rocker") + link("rod") + link("slider");
  const std::string text =
      robot(bars + joint("A", {"base", "crank"}) + joint("B", {"crank", "coupler", "0.3 0 0"}) +
            joint("C", {"base", "rocker", "0.5 0 0"}) + joint("E", {"crank", "rod", "0.2 0 0"}) +
            joint("x", {"base", "slider", "0 0 0", "1 0 0"}, "type=\"prismatic\"") +
            "<loop name=\"D\" type=\"spherical\">" + end("predecessor", "coupler", "xyz=\"0.6 0 0\"") +
            end("successor", "rocker", "xyz=\"0.4 0 0\"") + "</loop>" + "<loop name=\"F\" type=\"spherical\">" +
            end("predecessor", "slider", "xyz=\"0 0 0\"") + end("successor", "rod", "xyz=\"0.8 0 0\"") + "</loop>");
  const Mechanism found = make_mechanism(read("r.urdf", text));
  ASSERT_EQ(found.loops.size(), 2U);
  EXPECT_THAT(dependent_of(found, 0), ElementsAre("B", "C"));
  EXPECT_THAT(dependent_of(found, 1), ElementsAre("E", "x"));
  EXPECT_EQ(diagnostics_.all().size(), 2U);  // both choices are noted
}

// The plane of the mechanism may lie anywhere; angles that are no parts of a turn leave its axes parallel to 40 digits.
TEST_F(UrdfLoops, AxesInATiltedPlaneAreParallel) {
  const std::string text = robot(
      link("plate") + link("crank") + link("coupler") + link("rocker") +
      R"(<joint name="bolt" type="fixed"><parent link="base"/><child link="plate"/><origin rpy="0.5 0.3 -0.2"/></joint>)" +
      joint("A", {"plate", "crank", "0.1 0 0", "1 2 2"}) +
      joint("B", {"crank", "coupler", "0.2 -0.1 0", "-1 -2 -2"}, kDependent) +
      joint("C", {"plate", "rocker", "0.5 0 -0.2", "1 2 2"}, kDependent) + "<loop name=\"D\" type=\"revolute\">" +
      end("predecessor", "coupler", "xyz=\"0 0.3 -0.3\"") + end("successor", "rocker", "xyz=\"0.2 -0.1 0\"") +
      "<axis xyz=\"1 2 2\"/></loop>");
  const Mechanism found = make_mechanism(read("r.urdf", text));
  ASSERT_EQ(found.loops.size(), 1U);
  EXPECT_EQ(found.loops[0].rows.size(), 2U);
}

// Dust that CAD leaves of zeros would make a mechanism in a plane one in space.
TEST_F(UrdfLoops, DustInAxesAndPointsIsNone) {
  const std::string text =
      robot(link("crank") + link("coupler") + link("rocker") + joint("A", {"base", "crank", "0 0 0", "1.2e-15 0 1"}) +
            joint("B", {"crank", "coupler", "0.3 0 0", "0 -3e-16 1"}, kDependent) +
            joint("C", {"base", "rocker", "0.5 0 1e-17"}, kDependent) + "<loop name=\"D\" type=\"revolute\">" +
            end("predecessor", "coupler", "xyz=\"0.6 0 -2.1e-18\"") +
            end("successor", "rocker", "xyz=\"0.4 1e-17 0\"") + "<axis xyz=\"0 -1.2e-15 1\"/></loop>");
  const Mechanism found = make_mechanism(read("r.urdf", text));
  ASSERT_EQ(found.loops.size(), 1U);
  EXPECT_EQ(found.loops[0].rows.size(), 2U);
}

// A hinge in space: five joints follow, and axes of any length are unit in their links' bodies.
TEST_F(UrdfLoops, AHingeInSpaceTakesFiveJoints) {
  std::string text;
  const char *const axes[] = {"0 0 1", "0 1 0", "1 0 0"}, *const links[] = {"base", "a", "b", "c", "d", "e", "f"};
  for (std::size_t k = 1; k < 7; ++k) {
    text += link(links[k]) + joint(std::string("J") + links[k], {links[k - 1], links[k], "0.2 0.05 0.1", axes[k % 3]});
  }
  const Mechanism found = make_mechanism(
      read("r.urdf",
           robot(text + "<loop name=\"D\" type=\"revolute\">" + end("predecessor", "f", "xyz=\"0.1 0 0\"") +
                 end("successor", "base", "xyz=\"0.3 0.3 0\" rpy=\"0.4 0 0.2\"") + "<axis xyz=\"0 2 0\"/></loop>")));
  ASSERT_EQ(found.loops.size(), 1U);
  EXPECT_THAT(dependent_of(found, 0), ElementsAre("Jb", "Jc", "Jd", "Je", "Jf"));
  EXPECT_EQ(found.loops[0].rows, (std::vector<std::size_t>{0, 1, 2, 3, 4}));
  EXPECT_TRUE(vanishes(dot(found.loops[0].axis, found.loops[0].axis) - 1));
}

// A ball joint in space: three joints follow.
TEST_F(UrdfLoops, ABallJointInSpaceTakesThreeJoints) {
  const std::string text =
      robot(link("a") + link("b") + link("c") + link("d") + joint("A", {"base", "a"}) +
            joint("B", {"a", "b", "0.3 0 0", "0 1 0"}) + joint("C", {"b", "c", "0.2 0 0.1", "1 0 0"}) +
            joint("E", {"base", "d", "0.5 0 0", "0 2 1"}) + "<loop name=\"D\" type=\"spherical\">" +
            end("predecessor", "c", "xyz=\"0.2 0.1 0\"") + end("successor", "d", "xyz=\"0 0.3 0\"") + "</loop>");
  const Mechanism found = make_mechanism(read("r.urdf", text));
  ASSERT_EQ(found.loops.size(), 1U);
  EXPECT_THAT(dependent_of(found, 0), ElementsAre("B", "C", "E"));
}

}  // namespace
}  // namespace flatdyn
