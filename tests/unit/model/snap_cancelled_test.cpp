// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/snap_cancelled.hpp"

#include <gtest/gtest.h>

#include "unit/input/robot_file.hpp"

namespace flatdyn {
namespace {

class CancelledDust : public RobotFiles {
 protected:
  // A link of 3 kg with its centre of mass at `com`, and another of 1 kg fixed to it at (-0.3, 0.1, 0), turned by
  // `yaw`.
  Robot merged(const std::string& com, const std::string& xy = "0.001", const std::string& yaw = "0.4") {
    return read("r.urdf",
                "<robot name='r'><link name='base'/>\n<link name='a'><inertial><origin xyz='" + com +
                    "'/><mass value='3'/><inertia ixx='0.1' iyy='0.1' izz='0.1' ixy='" + xy +
                    "' ixz='0' iyz='0'/></inertial></link>\n<link name='b'><inertial><mass value='1'/><inertia "
                    "ixx='0.1' iyy='0.1' izz='0.1' ixy='0' ixz='0' iyz='0'/></inertial></link>\n<joint name='j' "
                    "type='continuous'><parent link='base'/><child link='a'/><axis xyz='0 0 1'/></joint>\n<joint "
                    "name='f' type='fixed'><parent link='a'/><child link='b'/><origin xyz='-0.3 0.1 0' rpy='0 0 " +
                    yaw + "'/></joint></robot>");
  }
  static Mechanism snapped(Robot& robot) { return snap_cancelled(exact_decimal("1e-9"), robot); }
};

TEST_F(CancelledDust, FirstMomentsThatCancelButForDust) {
  Robot robot = merged("0.10000000000000001 0.1 0");
  const Mechanism before = make_mechanism(robot), after = snapped(robot);
  const Vec3 &dusty = before.bodies[0].inertia.first_moment, &clean = after.bodies[0].inertia.first_moment;
  EXPECT_FALSE(dusty[0].is_zero());
  EXPECT_TRUE(clean[0].is_zero());
  EXPECT_TRUE(clean[1].is_equal(dusty[1]));
  ASSERT_EQ(robot.snaps.size(), 1U);
  EXPECT_EQ(robot.snaps[0].what, "what moves with link \"a\", first moment, x of its frame in flatdyn");
  EXPECT_EQ(robot.snaps[0].written, "3e-17");
  EXPECT_EQ(robot.snaps[0].kind, Snap::Kind::first_moment);
  EXPECT_EQ(robot.snaps[0].place.line, 2);
}

TEST_F(CancelledDust, OthersStay) {
  for (const char* com : {"0.1 0.1 0", "0.100000001 0.1 0"}) {  // zero already; 1e-9 m relative to 0.3 m
    Robot robot = merged(com);
    const Mechanism before = make_mechanism(robot), after = snapped(robot);
    EXPECT_TRUE(robot.snaps.empty()) << com;
    EXPECT_TRUE(after.bodies[0].inertia.first_moment[0].is_equal(before.bodies[0].inertia.first_moment[0])) << com;
  }
}

TEST_F(CancelledDust, ProductsThatCancelButForDust) {
  // -0.03 of the second body beside -3 · 0.2 · (-0.05) of the first
  Robot robot = merged("0.2 -0.05 0", "0.00000000000001");
  const Mechanism after = snapped(robot);
  EXPECT_FALSE(after.bodies[0].inertia.inertia[0][1].is_zero());  // 0.06
  Robot cancelling = merged("-0.2 0.05 0", "-0.0600000000000001");
  const Mechanism dusty = make_mechanism(cancelling), clean = snapped(cancelling);
  EXPECT_NEAR(nearest_double(dusty.bodies[0].inertia.inertia[0][1]), -1e-16, 1e-20);
  EXPECT_TRUE(clean.bodies[0].inertia.inertia[0][1].is_zero());
  ASSERT_EQ(cancelling.snaps.size(), 1U);
  EXPECT_EQ(cancelling.snaps[0].kind, Snap::Kind::product_of_inertia);
}

TEST_F(CancelledDust, AreUndoneAlone) {
  Robot robot = merged("0.10000000000000001 0.1 0");
  const Mechanism before = make_mechanism(robot);
  snapped(robot);
  Robot undone = robot;
  for (const Snap& snap : robot.snaps) snap.undo(undone);
  EXPECT_TRUE(
      make_mechanism(undone).bodies[0].inertia.first_moment[0].is_equal(before.bodies[0].inertia.first_moment[0]));
}

TEST_F(CancelledDust, AxesThatMeetButForDust) {
  // A displacement of 0.3 m at 0.3 rad with 15 digits: the second joint's axis intersects the first's up to rounding.
  const std::string text =
      "<robot name='r'><link name='base'/><link name='a'/><link name='b'><inertial><origin xyz='0 0.1 0.2'/><mass "
      "value='3'/><inertia ixx='0.1' iyy='0.1' izz='0.1' ixy='0' ixz='0' iyz='0'/></inertial></link>\n<joint name='i' "
      "type='continuous'><parent link='base'/><child link='a'/><axis xyz='0 0 1'/></joint>\n<joint name='j' "
      "type='continuous'><parent link='a'/><child link='b'/><origin xyz='0.286600946737682 0.0886560619984019 0' "
      "rpy='0 0 0.3'/><axis xyz='1 0 0'/></joint></robot>";
  Robot robot = read("r.urdf", text);
  const Mechanism before = make_mechanism(robot), after = snapped(robot);
  EXPECT_FALSE(before.bodies[1].p[0].is_zero());
  EXPECT_NEAR(nearest_double(before.bodies[1].p[0]), 0, 1e-15);
  for (const Number& each : after.bodies[1].p) EXPECT_TRUE(each.is_zero()) << each;
  ASSERT_EQ(robot.snaps.size(), 1U);
  EXPECT_EQ(robot.snaps[0].kind, Snap::Kind::length);
  EXPECT_EQ(robot.snaps[0].what, "joint \"j\", distance from the joint before, x of its frame in flatdyn");
  Robot undone = robot;
  robot.snaps[0].undo(undone);
  EXPECT_TRUE(make_mechanism(undone).bodies[1].p[0].is_equal(before.bodies[1].p[0]));
}

// Two joints with perpendicular axes, by frames that are turned by 0.3 and -0.3 rad in between.
std::string turned_arm(const std::string& back, const std::string& axis = "0 1 0") {
  return "<robot name='r'><link name='base'/><link name='a'/><link name='b'><inertial><origin xyz='0 0.1 0.2'/><mass "
         "value='3'/><inertia ixx='0.1' iyy='0.1' izz='0.1' ixy='0' ixz='0' iyz='0'/></inertial></link>\n<joint "
         "name='i' "
         "type='continuous'><parent link='base'/><child link='m'/><axis xyz='0 0 1'/></joint><link name='m'/>\n<joint "
         "name='f' type='fixed'><parent link='m'/><child link='a'/><origin rpy='0.3 0 0'/></joint>\n<joint name='j' "
         "type='continuous'><parent link='a'/><child link='b'/><origin xyz='0.1 0.2 0.3' rpy='" +
         back + " 0 0'/><axis xyz='" + axis + "'/></joint></robot>";
}

TEST_F(CancelledDust, AxesAtARightAngleButForDust) {
  Robot robot = read("r.urdf", turned_arm("-0.29999999999999"));
  const Mechanism before = make_mechanism(robot), after = snapped(robot);
  EXPECT_NEAR(nearest_double(before.bodies[1].alpha.c), 0, 2e-14);
  EXPECT_FALSE(before.bodies[1].alpha.c.is_zero());
  EXPECT_TRUE(after.bodies[1].alpha.c.is_zero());
  ASSERT_EQ(robot.snaps.size(), 1U);
  EXPECT_EQ(robot.snaps[0].kind, Snap::Kind::angle);
  EXPECT_EQ(robot.snaps[0].what, "joint \"j\", angle to the axis of the joint before");
  EXPECT_NEAR(std::abs(nearest_double(robot.snaps[0].difference)), 1e-14, 1e-16);
  Robot undone = robot;
  robot.snaps[0].undo(undone);
  EXPECT_NEAR(nearest_double(make_mechanism(undone).bodies[1].alpha.c - before.bodies[1].alpha.c), 0, 1e-40);
}

TEST_F(CancelledDust, ParallelAxesButForDust) {
  Robot robot = read("r.urdf", turned_arm("-0.29999999999999", "0 0 1"));
  const Mechanism before = make_mechanism(robot), after = snapped(robot);
  EXPECT_FALSE(before.bodies[1].alpha.is_identity());
  EXPECT_TRUE(after.bodies[1].alpha.is_identity());
  EXPECT_EQ(robot.snaps.size(), 1U);
}

TEST_F(CancelledDust, OtherAnglesStay) {
  for (const char* back : {"-0.3", "-0.299999998", "0.1"}) {
    Robot robot = read("r.urdf", turned_arm(back));
    snapped(robot);
    EXPECT_TRUE(robot.snaps.empty()) << back;
  }
}

TEST_F(CancelledDust, CanBeTurnedOff) {
  Robot robot = merged("0.10000000000000001 0.1 0");
  snap_cancelled(0, robot);
  EXPECT_TRUE(robot.snaps.empty());
}

}  // namespace
}  // namespace flatdyn
