// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include "unit/input/robot_file.hpp"

namespace flatdyn {
namespace {

using Kind = Displacement::Kind;

class TomlReader : public RobotFiles {
 protected:
  static std::vector<Kind> kinds(const Pose& pose) {
    std::vector<Kind> all;
    for (const Displacement& displacement : pose.displacements) all.push_back(displacement.kind);
    return all;
  }
  static GiNaC::symbol symbol(const Robot& robot, const std::string& name) {
    for (const FreeSymbol& free : robot.symbols) {
      if (free.name == name) return free.symbol;
    }
    throw std::out_of_range(name);
  }
};

constexpr const char* kPlanar = R"(name = "planar_2r"
gravity = [0, "-g", 0]
dh = "standard"
[[link]]
name = "upper"
joint = "shoulder"
a = "a_1"
alpha = "pi/2"
d = 0.5
theta = 0.1
mass = "m_1"
com = ["l_1 - a_1", 0, 1_0.5e-1]
inertia = { xx = 1, yy = 1, zz = "I_1", xy = -0.1 }
inertia_about = "origin"
viscous = 0.01
coulomb = "f_s"
limits = { lower = "-pi", upper = 3, velocity = inf, acceleration = 10, effort = 7 }
[link.motor]
mass = "m_m"
inertia = "I_m"
gear_ratio = 100
axis = [0, 1, 0]
position = [0, 0, 0.25]
carrier = "upper"
[[link]]
type = "prismatic"
mass = 1
armature = 1e-3
)";

TEST_F(TomlReader, ReadsEveryKey) {
  const Robot robot = read("planar.toml", kPlanar);
  EXPECT_EQ(robot.name, "planar_2r");
  EXPECT_TRUE(robot.gravity[1].is_equal(-symbol(robot, "g")));
  ASSERT_EQ(robot.links.size(), 3U);
  EXPECT_EQ(robot.links[0].name, "base");
  EXPECT_EQ(robot.links[2].name, "link2");
  const Inertial& inertial = robot.links[1].inertials.at(0);
  EXPECT_EQ(inertial.about, Inertial::About::frame_origin);
  EXPECT_TRUE(inertial.centre_of_mass[0].is_equal(symbol(robot, "l_1") - symbol(robot, "a_1")));
  EXPECT_TRUE(inertial.centre_of_mass[2].is_equal(Number(105) / 100));
  EXPECT_TRUE(inertial.tensor[2][2].is_equal(symbol(robot, "I_1")));
  EXPECT_TRUE(inertial.tensor[1][0].is_equal(Number(-1) / 10));
  const Joint& joint = robot.joints[0];
  EXPECT_EQ(joint.name, "shoulder");
  EXPECT_TRUE(joint.viscous.number.is_equal(Number(1) / 100));
  EXPECT_TRUE(joint.coulomb.number.is_equal(symbol(robot, "f_s")));
  EXPECT_TRUE(joint.limits.lower->number.is_equal(-GiNaC::Pi));
  EXPECT_FALSE(joint.limits.velocity.has_value());
  EXPECT_TRUE(joint.limits.effort->number.is_equal(7));
  ASSERT_TRUE(joint.motor.has_value());
  EXPECT_EQ(joint.motor->carrier, 1);
  EXPECT_TRUE(joint.motor->gear_ratio.number.is_equal(100));
  EXPECT_TRUE(joint.motor->axis[1].is_equal(1));
  EXPECT_TRUE(joint.motor->position[2].is_equal(Number(1) / 4));
  EXPECT_EQ(robot.joints[1].name, "joint2");
  EXPECT_EQ(robot.joints[1].type, JointType::prismatic);
  EXPECT_TRUE(robot.joints[1].armature.number.is_equal(Number(1) / 1000));
  EXPECT_EQ(robot.joints[1].parent, 1);
  EXPECT_EQ(robot.tip, 2);
}

TEST_F(TomlReader, ReadsSpringsInTheFilesUnits) {
  const Robot robot = read("r.toml", R"(angles = "deg"
lengths = "mm"
[[link]]
mass = 1
stiffness = "k"
spring_reference = 30
[[link]]
type = "prismatic"
mass = 1
stiffness = 200
spring_reference = 30
)");
  EXPECT_TRUE(robot.joints[0].stiffness.number.is_equal(symbol(robot, "k")));
  EXPECT_TRUE(robot.joints[0].spring_reference.number.is_equal(GiNaC::Pi / 6));
  EXPECT_TRUE(robot.joints[1].stiffness.number.is_equal(200));
  EXPECT_TRUE(robot.joints[1].spring_reference.number.is_equal(Number(3) / 100));
  EXPECT_EQ(robot.symbols.at(0).unit, "N m/rad or N/m");
}

TEST_F(TomlReader, KeepsSymbolsInOrderOfAppearance) {
  std::vector<std::string> names;
  for (const FreeSymbol& free : read("planar.toml", kPlanar).symbols) names.push_back(free.name);
  EXPECT_EQ(names, (std::vector<std::string>{"g", "a_1", "m_1", "l_1", "I_1", "f_s", "m_m", "I_m"}));
}

TEST_F(TomlReader, StandardDhFollowsTheMotion) {
  const Joint joint = read("planar.toml", kPlanar).joints.at(0);
  EXPECT_TRUE(joint.origin.displacements.empty());
  // Rz(theta) Tz(d) Tx(a) Rx(alpha)
  EXPECT_EQ(kinds(joint.link_offset), (std::vector<Kind>{Kind::rotation_z, Kind::translation, Kind::rotation_x}));
  EXPECT_TRUE(joint.link_offset.displacements[0].angle.is_equal(Number(1) / 10));
  EXPECT_TRUE(joint.link_offset.displacements[1].translation[2].is_equal(Number(1) / 2));
  EXPECT_TRUE(joint.link_offset.displacements[2].angle.is_equal(GiNaC::Pi / 2));
}

TEST_F(TomlReader, ModifiedDhPrecedesTheMotion) {
  const Joint joint =
      read("r.toml", "dh = \"modified\"\n[[link]]\nmass = 1\na = 2\nalpha = \"pi/2\"\nd = 3\ntheta = 0.1\n")
          .joints.at(0);
  EXPECT_TRUE(joint.link_offset.displacements.empty());
  // Rx(alpha) Tx(a) Tz(d) Rz(theta), Rx and Tx exchanged
  EXPECT_EQ(kinds(joint.origin),
            (std::vector<Kind>{Kind::translation, Kind::rotation_x, Kind::translation, Kind::rotation_z}));
  EXPECT_TRUE(joint.origin.displacements[0].translation[0].is_equal(2));
  EXPECT_TRUE(joint.origin.displacements[2].translation[2].is_equal(3));
}

TEST_F(TomlReader, PlacesLinksLikeUrdf) {
  const Joint joint =
      read("r.toml", "[[link]]\nmass = 1\nxyz = [0, 0, 1]\nrpy = [0, 0, \"pi/2\"]\naxis = [0, 1, 0]\n").joints.at(0);
  EXPECT_EQ(kinds(joint.origin), (std::vector<Kind>{Kind::translation, Kind::rotation_z}));
  EXPECT_TRUE(joint.axis[1].is_equal(1));
}

TEST_F(TomlReader, ReadsTreesTipAndPayload) {
  const Robot robot = read("r.toml", R"(base = "torso"
[[link]]
name = "left"
mass = 1
[[link]]
name = "right"
parent = "torso"
mass = 1
[tip]
link = "left"
xyz = [0, 0, 0.1]
rpy = ["pi", 0, 0]
[payload]
mass = 3
com = [0, 0, 1]
)");
  EXPECT_EQ(robot.joints[1].parent, 0);
  EXPECT_EQ(robot.tip, 1);
  EXPECT_EQ(kinds(robot.tip_offset), (std::vector<Kind>{Kind::translation, Kind::rotation_x}));
  ASSERT_EQ(robot.links[1].inertials.size(), 2U);
  EXPECT_TRUE(robot.links[1].inertials[1].mass.number.is_equal(3));
}

TEST_F(TomlReader, APayloadStaysWhenTheTipIsChosen) {
  ReadOptions options;
  options.tip = "base";
  const Robot robot = read("r.toml", "[[link]]\nmass = 1\n[payload]\nmass = 3\n", options);
  EXPECT_EQ(robot.tip, 0);
  EXPECT_EQ(robot.links[1].inertials.size(), 2U);
}

TEST_F(TomlReader, ARotorHeldStillIsABody) {
  ReadOptions options;
  options.scene.locked = {{"joint2"}};
  const Robot robot = read("r.toml",
                           "[[link]]\nmass = 1\n[[link]]\nmass = 1\n[link.motor]\nmass = 2\ninertia = 4\n"
                           "inertia_transverse = 3\naxis = [0, 3, 4]\nposition = [1, 0, 0]\n",
                           options);
  EXPECT_FALSE(robot.joints[1].motor.has_value());
  ASSERT_EQ(robot.links[1].inertials.size(), 2U);
  const Inertial& rotor = robot.links[1].inertials[1];
  EXPECT_TRUE(rotor.mass.number.is_equal(2));
  EXPECT_TRUE(rotor.centre_of_mass[0].is_equal(1));
  EXPECT_TRUE(rotor.tensor[0][0].is_equal(3));
  EXPECT_TRUE(rotor.tensor[1][1].is_equal(3 + Number(9) / 25));  // 3 + (4 - 3) (3/5)^2
  EXPECT_TRUE(rotor.tensor[1][2].is_equal(Number(12) / 25));
}

TEST_F(TomlReader, SymbolsInProductsAndPowersHaveNoQuantity) {
  const Robot robot = read("r.toml", R"toml([[link]]
mass = "rho*l"
com = ["l", "l/2 + 0.1", "2*(l - 1)"]
viscous = "2*l^2"
inertia = { zz = "m*l^2 + I" }
inertia_about = "com"
coulomb = "f*I/m"
)toml");
  EXPECT_EQ(robot.symbols.size(), 5U);
}

TEST_F(TomlReader, NumbersNeverPassThroughADouble) {
  const auto mass = [&](const std::string& text) {
    return read("r.toml", "# ä\n\"name\" = 'ö'\n[[link]]\nmass = " + text + "\n").links[1].inertials[0].mass.number;
  };
  EXPECT_TRUE(mass("0.1").is_equal(Number(1) / 10));
  EXPECT_TRUE(
      mass("0.10000000000000000000000000000000001").is_equal(exact_decimal("0.10000000000000000000000000000000001")));
  EXPECT_TRUE(mass("+1_000.5e-1 # kg").is_equal(Number(10005) / 100));
  EXPECT_TRUE(mass("0x10").is_equal(16));
  EXPECT_TRUE(mass("9007199254740993").is_equal(Number(GiNaC::numeric("9007199254740993"))));
}

TEST_F(TomlReader, ColumnsCountCharactersNotBytes) {
  const Robot robot = read("r.toml", "\xEF\xBB\xBFname = \"größe\"\nlink = [{ name = \"ü\", mass = 0.3 }]\n");
  EXPECT_TRUE(robot.links[1].inertials[0].mass.number.is_equal(Number(3) / 10));
}

}  // namespace
}  // namespace flatdyn
