// SPDX-License-Identifier: GPL-2.0-or-later
// Robot files in degrees and millimetres, which are the same robots exactly; and files that perhaps are, which are
// asked.
#include <gmock/gmock.h>

#include "robot/model/mechanism.hpp"
#include "unit/input/robot_file.hpp"

namespace flatdyn {
namespace {

using ::testing::HasSubstr;

class InUnits : public RobotFiles {
 protected:
  std::vector<std::string> warnings() const {
    std::vector<std::string> all;
    for (const Diagnostic& each : diagnostics_.all()) {
      if (each.severity == Severity::warning) all.push_back(each.message);
    }
    return all;
  }
  std::string errors_of(const std::string& text) {
    diagnostics_ = {};
    read_robot(write("r.toml", text), {}, diagnostics_);
    std::string all;
    for (const Diagnostic& each : diagnostics_.all()) {
      if (each.severity == Severity::error) all += to_string(each) + "\n";
    }
    return all;
  }
};

void expect_equal(const Number& a, const Number& b) { EXPECT_TRUE(vanishes(a - b)) << a << " is not " << b; }

void expect_equal(const Pose& a, const Pose& b) {
  ASSERT_EQ(a.displacements.size(), b.displacements.size());
  for (std::size_t i = 0; i < a.displacements.size(); ++i) {
    expect_equal(a.displacements[i].angle, b.displacements[i].angle);
    for (std::size_t k = 0; k < 3; ++k) {
      expect_equal(a.displacements[i].translation[k], b.displacements[i].translation[k]);
    }
  }
}

void expect_equal(const std::optional<Value>& a, const std::optional<Value>& b) {
  ASSERT_EQ(a.has_value(), b.has_value());
  if (a) expect_equal(a->number, b->number);
}

void expect_equal(const Joint& a, const Joint& b) {
  expect_equal(a.origin, b.origin);
  expect_equal(a.link_offset, b.link_offset);
  for (std::optional<Value> Limits::*limit :
       {&Limits::lower, &Limits::upper, &Limits::velocity, &Limits::acceleration, &Limits::effort}) {
    expect_equal(a.limits.*limit, b.limits.*limit);
  }
  ASSERT_EQ(a.coupled.has_value(), b.coupled.has_value());
  if (a.coupled) expect_equal(a.coupled->offset, b.coupled->offset);
  ASSERT_EQ(a.held.has_value(), b.held.has_value());
  if (a.held) expect_equal(a.held->position, b.held->position);
  ASSERT_EQ(a.motor.has_value(), b.motor.has_value());
  if (a.motor) {
    expect_equal(a.motor->inertia_axial.number, b.motor->inertia_axial.number);
    for (std::size_t k = 0; k < 3; ++k) expect_equal(a.motor->position[k], b.motor->position[k]);
  }
}

void expect_equal(const Robot& a, const Robot& b) {
  ASSERT_EQ(a.joints.size(), b.joints.size());
  for (std::size_t j = 0; j < a.joints.size(); ++j) expect_equal(a.joints[j], b.joints[j]);
  expect_equal(a.tip_offset, b.tip_offset);
  ASSERT_EQ(a.links.size(), b.links.size());
  for (std::size_t i = 0; i < a.links.size(); ++i) {
    ASSERT_EQ(a.links[i].inertials.size(), b.links[i].inertials.size());
    for (std::size_t p = 0; p < a.links[i].inertials.size(); ++p) {
      const Inertial &of_a = a.links[i].inertials[p], &of_b = b.links[i].inertials[p];
      for (std::size_t k = 0; k < 3; ++k) {
        expect_equal(of_a.centre_of_mass[k], of_b.centre_of_mass[k]);
        for (std::size_t l = 0; l < 3; ++l) expect_equal(of_a.tensor[k][l], of_b.tensor[k][l]);
      }
    }
  }
}

// An arm with all that angles and lengths are written for.
constexpr const char* kInDegrees = R"(angles = "deg"
lengths = "mm"
dh = "standard"
fixed = { wrist = 30, slide = 12.5 }
[[link]]
joint = "shoulder"
alpha = 90
d = 180.7
theta = "180/4"
a = -17.3e-1
mass = 2
com = [1, "-2/3", 0]
inertia = { xx = 0.1, yy = 0.1, zz = 0.1 }
inertia_about = "com"
limits = { lower = -170, upper = 360, velocity = 180, acceleration = 720, effort = 90 }
motor = { inertia = 1e-4, position = [0, 0, -30] }
[[link]]
joint = "lift"
type = "prismatic"
alpha = 17.3
mass = 1
limits = { lower = 0, upper = 800, velocity = 250, acceleration = 1000, effort = 100 }
[[link]]
joint = "elbow"
position = "2*shoulder - 45"
mass = 1
[[link]]
joint = "follower"
type = "prismatic"
position = "lift + 20"
mass = 1
[[link]]
joint = "wrist"
mass = 1
[[link]]
joint = "slide"
type = "prismatic"
mass = 1
[tip]
xyz = [0, 0, 92.2]
rpy = [0, -90, 89.99999]
[payload]
mass = 1
com = [10, 0, 0]
)";

constexpr const char* kInRadians = R"(dh = "standard"
fixed = { wrist = "pi/6", slide = 0.0125 }
[[link]]
joint = "shoulder"
alpha = "pi/2"
d = 0.1807
theta = "pi/4"
a = -0.00173
mass = 2
com = [0.001, "-2/3000", 0]
inertia = { xx = 0.1, yy = 0.1, zz = 0.1 }
inertia_about = "com"
limits = { lower = "-17*pi/18", upper = "2*pi", velocity = "pi", acceleration = "4*pi", effort = 90 }
motor = { inertia = 1e-4, position = [0, 0, -0.03] }
[[link]]
joint = "lift"
type = "prismatic"
alpha = "173*pi/1800"
mass = 1
limits = { lower = 0, upper = 0.8, velocity = 0.25, acceleration = 1, effort = 100 }
[[link]]
joint = "elbow"
position = "2*shoulder - pi/4"
mass = 1
[[link]]
joint = "follower"
type = "prismatic"
position = "lift + 0.02"
mass = 1
[[link]]
joint = "wrist"
mass = 1
[[link]]
joint = "slide"
type = "prismatic"
mass = 1
[tip]
xyz = [0, 0, 0.0922]
rpy = [0, "-pi/2", "pi/2"]
[payload]
mass = 1
com = [0.01, 0, 0]
)";

TEST_F(InUnits, DegreesAndMillimetresAreTheSameRobotExactly) {
  const Robot robot = read("deg.toml", kInDegrees);
  EXPECT_THAT(warnings(), ::testing::IsEmpty());
  ASSERT_EQ(robot.snaps.size(), 1U);  // 89.99999
  EXPECT_EQ(robot.snaps[0].written, "89.99999");
  expect_equal(robot, read("rad.toml", kInRadians));
}

TEST_F(InUnits, MechanismsTakeAnyNumberOfDegrees) {
  const Mechanism mechanism = make_mechanism(read("deg.toml", kInDegrees));
  EXPECT_EQ(mechanism.size(), 2);
}

TEST_F(InUnits, PosesByXyzAndRpyAndAssembliesAndLoopsAreScaledToo) {
  const std::string arm =
      "[[link]]\nname = \"upper\"\njoint = \"a\"\nxyz = [1000, 0, 0]\nrpy = [0, 0, 90]\nmass = 1\n"
      "[[link]]\nname = \"tip\"\njoint = \"s\"\ntype = \"prismatic\"\nmass = 1\n[assembly]\na = 45\ns = 250\n";
  const Robot robot = read("r.toml", "angles = \"deg\"\nlengths = \"mm\"\n" + arm);
  const std::vector<Displacement>& moves = robot.joints.at(0).origin.displacements;
  ASSERT_EQ(moves.size(), 2U);
  expect_equal(moves[0].translation[0], 1);
  expect_equal(moves[1].angle, GiNaC::Pi / 2);
  ASSERT_EQ(robot.assembly.size(), 2U);
  expect_equal(robot.assembly[0].position, GiNaC::Pi / 4);
  expect_equal(robot.assembly[1].position, Number(1) / 4);
}

TEST_F(InUnits, AFileOverAnotherHasUnitsOfItsOwn) {
  write("arm.urdf", one_joint_urdf("revolute", "<origin xyz=\"0 0 0.5\"/><limit lower=\"-1\" upper=\"1\"/>"));
  const Robot robot = read("over.toml",
                           "robot = \"arm.urdf\"\nangles = \"deg\"\nlengths = \"mm\"\n[[joint]]\nname = \"j\"\n"
                           "limits = { upper = 45 }\n[tip]\nxyz = [0, 0, 20]\n");
  const Joint& joint = robot.joints.at(0);
  expect_equal(joint.origin.displacements.at(0).translation[2], Number(1) / 2);
  expect_equal(joint.limits.lower->number, -1);
  expect_equal(joint.limits.upper->number, GiNaC::Pi / 4);
  expect_equal(robot.tip_offset.displacements.at(0).translation[2], Number(1) / 50);
}

TEST_F(InUnits, FreeSymbolsStayInRadiansAndMetres) {
  const Robot robot = read("r.toml",
                           "angles = \"deg\"\nlengths = \"mm\"\ndh = \"standard\"\n[[link]]\nalpha = \"alpha_1\"\n"
                           "a = \"2*a_1\"\nmass = 1\n");
  const std::vector<Displacement>& moves = robot.joints.at(0).link_offset.displacements;
  ASSERT_EQ(moves.size(), 2U);
  expect_equal(moves[0].translation[0], 2 * robot.symbols.at(1).symbol);
  expect_equal(moves[1].angle, robot.symbols.at(0).symbol);
}

TEST_F(InUnits, WhatWouldMixUnitsIsAnError) {
  EXPECT_EQ(
      errors_of("angles = \"deg\"\nlengths = \"mm\"\ndh = \"standard\"\n[[link]]\nalpha = \"pi/2\"\nmass = 1\n"
                "a = \"a_1 - 20\"\nlimits = { upper = \"3*pi\" }\n"),
      (folder_ / "r.toml").string() +
          ":5: error: link \"link1\", alpha: an expression with pi in a file in degrees: which are meant?\n"
          "    hint: write degrees without pi (pi/2 is 90), or leave angles = \"deg\" out\n" +
          (folder_ / "r.toml").string() +
          ":7: error: link \"link1\", a: a number is added to a symbol in a file in millimetres, but symbols are "
          "in metres\n"
          "    hint: give the number a symbol of its own, or write the file in metres\n" +
          (folder_ / "r.toml").string() +
          ":8: error: link \"link1\", limits, upper: an expression with pi in a file in degrees: which are meant?\n"
          "    hint: write degrees without pi (pi/2 is 90), or leave angles = \"deg\" out\n");
}

TEST_F(InUnits, LengthsAreAskedAboutBeyondTwentyMetresUnlessTheRobotWeighsTons) {
  const auto asked = [&](const std::string& length, const std::string& mass) {
    read("r.toml", "dh = \"standard\"\n[[link]]\nd = " + length + "\nmass = " + mass + "\n");
    return warnings();
  };
  EXPECT_THAT(asked("20", "5"), ::testing::IsEmpty());
  EXPECT_THAT(asked("20.1", "5"),
              ::testing::ElementsAre("link \"link1\", d: 20.1 m is long beside 5 kg in all; were millimetres meant?"));
  EXPECT_THAT(asked("20.1", "999"), ::testing::SizeIs(1));
  EXPECT_THAT(asked("-30", "1000"), ::testing::IsEmpty());
  EXPECT_THAT(asked("\"d_1\"", "1"), ::testing::IsEmpty());
}

TEST_F(InUnits, StrokesAndMomentsOfInertiaAreAskedAbout) {
  const auto asked = [&](const std::string& more) {
    read("r.toml", "[[link]]\ntype = \"prismatic\"\nmass = 2\n" + more);
    return warnings();
  };
  EXPECT_THAT(asked("limits = { lower = 0, upper = 20 }"), ::testing::IsEmpty());
  EXPECT_THAT(asked("limits = { lower = 0, upper = 1000 }"), ::testing::IsEmpty());  // written for none
  EXPECT_THAT(asked("limits = { lower = 0, upper = 800 }"),
              ::testing::ElementsAre("joint \"joint1\", limit: 800 m is far; were millimetres meant?"));
  EXPECT_THAT(asked("inertia_about = \"com\"\ninertia = { xx = 500, yy = 500, zz = 500 }"), ::testing::IsEmpty());
  EXPECT_THAT(asked("inertia_about = \"com\"\ninertia = { xx = 600, yy = 600, zz = 600 }"),
              ::testing::ElementsAre(HasSubstr("were kg mm^2 meant?")));
}

TEST_F(InUnits, HeldPositionsAreAskedAboutWhereverTheyAreSaid) {
  ReadOptions options;
  options.scene.locked = {{"j", 90, "90", true, {}}};
  const std::string robot = one_joint_urdf("revolute", "",
                                           "<link name=\"hand\"/>"
                                           "<joint name=\"k\" type=\"revolute\"><parent link=\"arm\"/>"
                                           "<child link=\"hand\"/></joint>");
  read("r.urdf", robot, options);
  ASSERT_THAT(warnings(), ::testing::Contains("joint \"j\", held at 90: 90 rad is 14 turns; were degrees meant?"));
  EXPECT_EQ(diagnostics_.all().front().hint, "if so, write --fix j=90deg");
  options.scene.locked = {{"j", Number(6), "6", true, {}}};
  read("r.urdf", robot, options);
  EXPECT_THAT(warnings(), ::testing::Not(::testing::Contains(HasSubstr("degrees"))));
}

}  // namespace
}  // namespace flatdyn
