// SPDX-License-Identifier: GPL-2.0-or-later
// Fixed tendons of MJCF files: lengths, forces, what drives them, and equalities of them.
#include <gmock/gmock.h>

#include "robot/model/coupling.hpp"
#include "robot/model/mechanism.hpp"
#include "unit/input/robot_file.hpp"

namespace flatdyn {
namespace {

class MjcfTendons : public RobotFiles {
 protected:
  // A finger with the joints i, j (in degrees) and the slide s.
  Robot finger(const std::string& after, const ReadOptions& options = {}) {
    const std::string mass = "<inertial pos=\"0.1 0 0\" mass=\"2\" diaginertia=\"1 1 1\"/>";
    return read("r.xml",
                "<mujoco><worldbody><body name=\"a\"><joint name=\"i\" ref=\"90\" springref=\"60\"/>" + mass +
                    "<body name=\"b\"><joint name=\"j\"/>" + mass +
                    "<body name=\"c\"><joint name=\"s\" type=\"slide\" ref=\"2\" springref=\"3\"/>" + mass +
                    "</body></body></body></worldbody>" + after + "</mujoco>",
                options);
  }

  std::size_t count_of_notes(const std::string& words) const {
    std::size_t count = 0;
    for (const Diagnostic& found : diagnostics_.all()) {
      if (found.severity == Severity::note && found.message.find(words) != std::string::npos) ++count;
    }
    return count;
  }
};

constexpr const char* kPath = R"(<joint joint="i" coef="2"/><joint joint="s" coef="-3"/>)";

std::string tendons(const std::string& forces) {
  return "<tendon><fixed name=\"pull\" " + forces + ">" + kPath + "</fixed></tendon>";
}

TEST_F(MjcfTendons, AreSlidesThatFollowTheirJoints) {
  const Robot robot =
      finger(tendons(R"(stiffness="5" springlength="0.25" damping="1" armature="0.5" frictionloss="2")"));
  ASSERT_EQ(robot.joints.size(), 4U);
  const Joint& tendon = robot.joints[3];
  EXPECT_TRUE(tendon.is_tendon);
  EXPECT_EQ(tendon.name, "pull");
  EXPECT_EQ(tendon.stiffness.number, 5);
  EXPECT_EQ(tendon.spring_reference.number, Number(1) / 4);
  EXPECT_EQ(tendon.viscous.number, 1);
  EXPECT_EQ(tendon.armature.number, Number(1) / 2);
  EXPECT_EQ(tendon.coulomb.number, 2);
  const LinearPosition length = joint_positions(robot)[3];
  EXPECT_EQ(length.factors.at(0), 2);
  EXPECT_EQ(length.factors.at(2), -3);
  EXPECT_EQ(length.offset, 0);
  EXPECT_EQ(robot.links[static_cast<std::size_t>(robot.tip)].name, "c");
}

// Without a springlength the spring is relaxed where all joints are at their springref, 2 · pi/3 - 3 · 3.
TEST_F(MjcfTendons, AreRelaxedWhereTheirJointsAre) {
  for (const char* length : {"", R"( springlength="-1")", R"( springlength="-1 -1")"}) {
    const Robot robot = finger(tendons(std::string(R"(stiffness="5")") + length));
    EXPECT_TRUE(vanishes(robot.joints.at(3).spring_reference.number - (2 * GiNaC::Pi / 3 - 9))) << length;
  }
}

TEST_F(MjcfTendons, WithoutForcesAreLeftOut) {
  EXPECT_EQ(finger(tendons("")).joints.size(), 3U);
  ReadOptions held;
  held.scene.locked = {{"i"}, {"s"}};
  EXPECT_EQ(finger(tendons(R"(stiffness="5")"), held).joints.size(), 3U);
  ReadOptions without_springs;
  without_springs.scene.springs = false;
  EXPECT_EQ(finger(tendons(R"(stiffness="5")"), without_springs).joints.size(), 3U);
}

TEST_F(MjcfTendons, HaveWhatTheirActuatorsReflect) {
  const Robot robot = finger(tendons(R"(armature="0.5")") +
                             R"(<actuator><motor tendon="pull" gear="3" armature="2" damping="0.5" ctrlrange="-1 1"/>
                                <motor joint="s" ctrlrange="-1 1"/></actuator>)");
  EXPECT_EQ(robot.joints.at(3).armature.number, Number(37) / 2);
  EXPECT_EQ(robot.joints.at(3).viscous.number, Number(9) / 2);
  EXPECT_EQ(count_of_notes("acts through tendon \"pull\""), 1U);
  EXPECT_FALSE(robot.joints.at(2).limits.effort);  // the tendon drives it, too
}

// MuJoCo has no entries of B for joints on different branches.
TEST_F(MjcfTendons, OverBranchesAreNoted) {
  const std::string mass = R"(<inertial pos="0 0 0" mass="2" diaginertia="1 1 1"/>)";
  read("r.xml", "<mujoco><worldbody><body><joint name=\"i\"/>" + mass + "</body><body><joint name=\"s\"/>" + mass +
                    "</body></worldbody>" + tendons(R"(armature="0.5")") + "</mujoco>");
  EXPECT_EQ(count_of_notes("on different branches"), 1U);
  finger(tendons(R"(armature="0.5")"));
  EXPECT_EQ(count_of_notes("on different branches"), 0U);
}

// 2 (i - pi/2) - 3 (s - 2) = 0.5: the last of the two follows, if nothing drives it.
TEST_F(MjcfTendons, CoupleJointsByAnEquality) {
  const std::string equality = R"(<equality><tendon tendon1="pull" polycoef="0.5"/></equality>)";
  const LinearPosition s = joint_positions(finger(tendons("") + equality)).at(2);
  EXPECT_EQ(s.factors.at(0), Number(2) / 3);
  EXPECT_TRUE(vanishes(s.offset - (Number(11) / 6 - GiNaC::Pi / 3)));
  const Robot driven = finger(tendons("") + equality + R"(<actuator><motor joint="s"/></actuator>)");
  EXPECT_TRUE(driven.joints.at(0).coupled);
  EXPECT_FALSE(driven.joints.at(2).coupled);
}

// L_1 - L_1(ref) = 2 (L_2 - L_2(ref)), where both run over i: it is left out, as it has a factor of 0 then.
TEST_F(MjcfTendons, CoupleTheJointsOfTwo) {
  const Robot robot = finger(R"(<tendon><fixed name="t"><joint joint="i" coef="4"/><joint joint="j" coef="1"/></fixed>
    <fixed name="u"><joint joint="i" coef="2"/><joint joint="s" coef="1"/></fixed></tendon>
    <equality><tendon tendon1="t" tendon2="u" polycoef="0 2 0 0 0"/></equality>)");
  const LinearPosition s = joint_positions(robot).at(2);
  EXPECT_EQ(s.factors.size(), 1U);
  EXPECT_EQ(s.factors.at(1), Number(1) / 2);
  EXPECT_EQ(s.offset, 2);
}

// i + j + s = 0 and i + 2 j + 3 s = 0, in either order, by elimination: j = -2 i, s = i.
TEST_F(MjcfTendons, AreSolvedTogether) {
  const std::string paths = R"(<tendon><fixed name="t"><joint joint="i" coef="1"/><joint joint="j" coef="1"/>
    <joint joint="s" coef="1"/></fixed><fixed name="u"><joint joint="i" coef="1"/><joint joint="j" coef="2"/>
    <joint joint="s" coef="3"/></fixed></tendon>)";
  for (const char* equalities :
       {R"(<tendon tendon1="t"/><tendon tendon1="u"/>)", R"(<tendon tendon1="u"/><tendon tendon1="t"/>)"}) {
    const std::vector<LinearPosition> q = joint_positions(finger(paths + "<equality>" + equalities + "</equality>"));
    EXPECT_EQ(q.at(1).factors.at(0), -2);
    EXPECT_EQ(q.at(2).factors.at(0), 1);
  }
  const Robot with_joints =
      finger(paths + R"(<equality><tendon tendon1="t"/><joint joint1="s" joint2="j"/></equality>)");
  EXPECT_EQ(joint_positions(with_joints).at(2).factors.at(0), Number(-1) / 2);
}

// A joint that is held does not follow: the other one does, and is held with it.
TEST_F(MjcfTendons, HeldJointsLead) {
  const std::string text = tendons("") + R"(<equality><tendon tendon1="pull"/></equality>)";
  ReadOptions held;
  held.scene.locked = {{"s", 0.5, "0.5", true}};
  const Robot robot = finger(text, held);
  ASSERT_TRUE(robot.joints.at(0).held);  // 2 (i - pi/2) = 3 (0.5 - 2)
  EXPECT_TRUE(vanishes(robot.joints.at(0).held->position - (GiNaC::Pi / 2 - Number(9) / 4)));
  const Robot by_equality = finger(text + R"(<equality><joint joint1="s" polycoef="-1.5"/></equality>)");
  EXPECT_TRUE(vanishes(by_equality.joints.at(0).held.value().position - (GiNaC::Pi / 2 - Number(9) / 4)));
}

// Beside a free base, what is held is left out, and its position put in.
TEST_F(MjcfTendons, KnowJointsThatAreLeftOut) {
  const std::string mass = R"(<inertial pos="0 0 0" mass="2" diaginertia="1 1 1"/>)";
  ReadOptions held;
  held.scene.locked = {{"spare", 0.5, "0.5", true}};
  const Robot robot = read("r.xml",
                           R"(<mujoco><worldbody><body><freejoint/>)" + mass + R"(<body><joint name="hip"/>)" + mass +
                               R"(</body></body><body><joint name="spare"/>)" + mass +
                               R"(</body></worldbody><tendon><fixed name="t" stiffness="3"><joint joint="hip" coef="1"/>
                               <joint joint="spare" coef="2"/></fixed></tendon></mujoco>)",
                           held);
  EXPECT_EQ(joint_positions(robot).back().offset, 1);
}

// As MuJoCo does, an actuator on a free joint adds to its six entries.
TEST_F(MjcfTendons, ActuatorsOnAFreeJointReflect) {
  const Robot robot = read("r.xml", R"(<mujoco><worldbody><body><joint name="root" type="free" armature="1"/>
    <inertial pos="0 0 0" mass="2" diaginertia="1 1 1"/></body></worldbody>
    <actuator><motor joint="root" gear="2 0 0 0 0 0" armature="3" damping="5"/></actuator></mujoco>)");
  EXPECT_EQ(robot.base_joint.armature.number, 13);
  EXPECT_EQ(robot.base_joint.viscous.number, 20);
}

TEST_F(MjcfTendons, HoldTheirOnlyJointByAnEquality) {
  const Robot robot = finger(R"(<tendon><fixed name="t"><joint joint="s" coef="4"/></fixed></tendon>
    <equality><tendon tendon1="t" polycoef="2"/></equality>)");
  ASSERT_TRUE(robot.joints.at(2).held);
  EXPECT_EQ(robot.joints.at(2).held->position, Number(5) / 2);
}

// Flags count where they turn off what the robot has.
TEST_F(MjcfTendons, FlagsThatTurnOffNothingAreFine) {
  EXPECT_EQ(finger(R"(<option><flag constraint="disable" passive="disable"/></option>)").joints.size(), 3U);
}

TEST_F(MjcfTendons, WeightsThatAreCarriedAreANote) {
  const Robot robot = read("r.xml", R"(<mujoco><worldbody><body name="a" gravcomp="1"><joint/>
    <inertial pos="0 0 0" mass="2" diaginertia="1 1 1"/></body></worldbody></mujoco>)");
  EXPECT_EQ(robot.joints.size(), 1U);
  EXPECT_EQ(count_of_notes("gravcomp"), 1U);
}

}  // namespace
}  // namespace flatdyn
