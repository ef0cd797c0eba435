// SPDX-License-Identifier: GPL-2.0-or-later
// Each kind of dust, on both sides of its threshold.
#include "robot/model/snap_dust.hpp"

#include <gtest/gtest.h>

#include "unit/input/robot_file.hpp"

namespace flatdyn {
namespace {

// Two links of a length; `origin` is that of the second joint, whose axis and body are given, too.
struct Dusty {
  std::string origin = "0 0 0.5";
  std::string axis = "0 0 1";
  std::string com = "0 0 0.1";
  std::string inertia = "ixx='0.01' iyy='0.02' izz='0.02' ixy='0' ixz='0' iyz='0'";
  std::string base = "0 0 0.3";

  std::string urdf() const {
    return "<robot name='r'><link name='base'/><link name='a'/>\n<link name='b'><inertial><origin xyz='" + com +
           "'/><mass value='2'/><inertia " + inertia +
           "/></inertial></link>\n<joint name='i' type='revolute'><parent link='base'/><child link='a'/><origin xyz='" +
           base + "'/></joint>\n<joint name='j' type='revolute'><parent link='a'/><child link='b'/><origin xyz='" +
           origin + "'/><axis xyz='" + axis + "'/></joint></robot>";
  }
};

class DustSnapping : public RobotFiles {
 protected:
  Robot of(const Dusty& dusty, const ReadOptions& options = {}) { return read("r.urdf", dusty.urdf(), options); }
  static std::vector<std::string> what(const Robot& robot) {
    std::vector<std::string> texts;
    for (const Snap& snap : robot.snaps) texts.push_back(snap.what);
    return texts;
  }
  static Vec3 axis(const Robot& robot) { return robot.joints.at(1).axis; }
};

using Texts = std::vector<std::string>;

void expect_equal(const Vec3& found, const Vec3& expected) {
  for (std::size_t k = 0; k < 3; ++k) EXPECT_TRUE(vanishes(found[k] - expected[k])) << k << ": " << found[k];
}

TEST_F(DustSnapping, AnAxisNearACoordinateAxisIsIt) {
  const Robot robot = of({.axis = "-1.2E-15 0 1"});
  expect_equal(axis(robot), {0, 0, 1});
  ASSERT_EQ(robot.snaps.size(), 1U);
  const Snap& snap = robot.snaps[0];
  EXPECT_EQ(snap.what, "joint \"j\", axis, x");
  EXPECT_EQ(snap.written, "-1.2e-15");
  EXPECT_EQ(snap.place.line, 4);
  EXPECT_TRUE(snap.exact.is_zero());
  EXPECT_EQ(snap.kind, Snap::Kind::axis);
  EXPECT_NEAR(nearest_double(snap.difference), 1.2e-15, 1e-24);
  EXPECT_EQ(of({.axis = "9e-10 -9e-10 -1"}).snaps.size(), 2U);
  EXPECT_TRUE(of({.axis = "2e-9 0 1"}).snaps.empty());
}

TEST_F(DustSnapping, OfAnAxisTheDirectionCounts) {
  EXPECT_EQ(of({.axis = "0 9e-9 10"}).snaps.size(), 1U);
  EXPECT_TRUE(of({.axis = "0 9e-10 0.1"}).snaps.empty());
  EXPECT_TRUE(of({.axis = "0 0 0.1"}).snaps.empty());
}

TEST_F(DustSnapping, AnAxisAtAMultipleOfATwelfthOfPiIsThere) {
  const Robot robot = of({.axis = "0.866025403784439 1e-17 -0.5"});
  expect_equal(axis(robot), {GiNaC::sqrt(Number(3)) / 2, 0, Number(-1) / 2});
  EXPECT_EQ(what(robot), (Texts{"joint \"j\", axis, x", "joint \"j\", axis, y"}));
  EXPECT_EQ(of({.axis = "0.7071067811 0.7071067812 0"}).snaps.size(), 2U);
  EXPECT_TRUE(of({.axis = "0.70710678 0.70710679 0"}).snaps.empty());
  EXPECT_TRUE(of({.axis = "1 1 0"}).snaps.empty());  // is there
  EXPECT_TRUE(of({.axis = "1 1 1"}).snaps.empty());
  EXPECT_TRUE(of({.axis = "0.6 0.8 0"}).snaps.empty());
}

TEST_F(DustSnapping, LengthsAreTinyBesideTheRobot) {
  const Robot robot = of({.origin = "1.2e-17 4e-10 0.5", .com = "-3e-17 0 0.1"});
  EXPECT_EQ(what(robot), (Texts{"joint \"j\", origin, x", "joint \"j\", origin, y", "link \"b\", inertial, x"}));
  EXPECT_EQ(robot.snaps[1].written, "4e-10");
  EXPECT_EQ(robot.snaps[1].kind, Snap::Kind::length);
  expect_equal(robot.joints[1].origin.displacements.at(0).translation, {0, 0, Number(1) / 2});
  EXPECT_TRUE(of({.origin = "6e-10 0 0.5"}).snaps.empty());
}

TEST_F(DustSnapping, ASmallRobotIsNoDust) {
  const Dusty insect = {.origin = "6e-16 0 5e-7", .com = "0 0 1e-7", .base = "0 0 0.3"};
  EXPECT_TRUE(of(insect).snaps.empty());
  Dusty dusty = insect;
  dusty.origin = "4e-16 0 5e-7";
  EXPECT_EQ(of(dusty).snaps.size(), 1U);
}

TEST_F(DustSnapping, AMicrometreIsNoDustWhereverTheRobotStands) {
  EXPECT_TRUE(of({.origin = "1e-6 0 0.5", .base = "455000 5217000 0"}).snaps.empty());
  EXPECT_TRUE(of({.origin = "1e-6 0 5000"}).snaps.empty());
}

TEST_F(DustSnapping, OneBodyOnItsAxisStandsBesideWhatCarriesIt) {
  EXPECT_EQ(of({.origin = "0 0 0", .com = "1e-17 0 0"}).snaps.size(), 1U);
}

TEST_F(DustSnapping, ProductsOfInertiaAreTinyBesideBothMoments) {
  const auto with = [&](const std::string& moments, const std::string& xy) {
    return of({.inertia = moments + " ixy='" + xy + "' ixz='0' iyz='0'"});
  };
  const Robot robot = with("ixx='0.01' iyy='0.02' izz='0.02'", "9e-12");
  EXPECT_EQ(what(robot), Texts{"link \"b\", inertia, xy"});
  EXPECT_EQ(robot.snaps[0].kind, Snap::Kind::product_of_inertia);
  EXPECT_TRUE(robot.links[2].inertials[0].tensor[0][1].is_zero());
  EXPECT_TRUE(robot.links[2].inertials[0].tensor[1][0].is_zero());
  EXPECT_TRUE(with("ixx='0.01' iyy='0.02' izz='0.02'", "1.1e-11").snaps.empty());
  EXPECT_TRUE(with("ixx='1e-9' iyy='0.02' izz='0.02'", "3e-12").snaps.empty());  // 3e-12 is no dust beside ixx
}

TEST_F(DustSnapping, AThinRodHasNoMomentThatProductsCouldStandBeside) {
  const Robot robot = of({.inertia = "ixx='0' iyy='0.02' izz='0.02' ixy='1e-18' ixz='0' iyz='0'"});
  EXPECT_EQ(robot.snaps.size(), 1U);
  EXPECT_FALSE(diagnostics_.has_warnings());  // without the dust it is physically consistent
}

TEST_F(DustSnapping, ABodyThatCanExistStaysOne) {
  // A rod along (2e-5, 2e-5, 1) with mass on its axis only: without the small ixy, some mass would have to be negative.
  const Robot robot = of({.inertia = "ixx='1.0000000004' iyy='1.0000000004' izz='0.0000000008' ixy='-0.0000000004' "
                                     "ixz='-0.00002' iyz='-0.00002'"});
  EXPECT_TRUE(robot.snaps.empty());
  EXPECT_FALSE(diagnostics_.has_warnings());
}

TEST_F(DustSnapping, MotorsAndGravity) {
  const auto motor = [&](const std::string& axis, const std::string& position, const std::string& gravity) {
    return read("r.toml", "gravity = [0, " + gravity +
                              ", -9.81]\ndh = \"modified\"\n[[link]]\nmass = 1\na = 1\n[[link]]\n"
                              "mass = 1\na = 0.5\nmotor = { inertia = 1e-4, axis = [0, " +
                              axis + ", 1], position = [" + position + ", 0, 0] }\n");
  };
  EXPECT_EQ(what(motor("1e-12", "1e-12", "1e-12")),
            (Texts{"gravity, y", "joint \"joint2\", motor, axis, y", "joint \"joint2\", motor, position, x"}));
  EXPECT_TRUE(motor("1e-8", "2e-9", "1e-7").snaps.empty());
}

TEST_F(DustSnapping, FollowsTheOption) {
  const Dusty dusty = {.origin = "1e-13 0 0.5",
                       .axis = "1e-13 0 1",
                       .inertia = "ixx='0.01' iyy='0.02' izz='0.02' ixy='1e-16' ixz='0' iyz='0'"};
  ReadOptions options;
  EXPECT_EQ(of(dusty, options).snaps.size(), 3U);
  options.snap_tolerance = exact_decimal("1e-14");
  EXPECT_EQ(of(dusty, options).snaps.size(), 0U);
  options.snap_tolerance = exact_decimal("1e-3");  // the tolerance is for angles; dust keeps its own threshold
  EXPECT_TRUE(of({.axis = "1e-4 0 1"}, options).snaps.empty());
  options.snap_tolerance = 0;
  const Robot robot = of(dusty, options);
  EXPECT_TRUE(robot.snaps.empty());
  EXPECT_TRUE(axis(robot)[0].is_equal(exact_decimal("1e-13")));
}

TEST_F(DustSnapping, LeavesSymbols) {
  const Robot robot = read("r.toml", "[[link]]\nmass = 1\nxyz = [\"1e-15*a\", 0, 1]\ncom = [\"1e-15*a\", 0, 0]\n");
  EXPECT_TRUE(robot.snaps.empty());
}

TEST_F(DustSnapping, CanBeUndone) {
  const Robot robot = of({.origin = "1e-13 0 0.5",
                          .axis = "1e-13 0 2",
                          .inertia = "ixx='0.01' iyy='0.02' izz='0.02' ixy='1e-16' ixz='0' iyz='0'"});
  Robot undone = robot;
  for (const Snap& snap : robot.snaps) snap.undo(undone);
  expect_equal(axis(undone), {exact_decimal("1e-13"), 0, 2});
  expect_equal(undone.joints[1].origin.displacements.at(0).translation, {exact_decimal("1e-13"), 0, Number(1) / 2});
  EXPECT_TRUE(undone.links[2].inertials[0].tensor[1][0].is_equal(exact_decimal("1e-16")));
  expect_equal(axis(robot), {0, 0, 2});
}

}  // namespace
}  // namespace flatdyn
