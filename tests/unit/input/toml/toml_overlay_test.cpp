// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include "unit/input/robot_file.hpp"

namespace flatdyn {
namespace {

constexpr const char* kOverlaidArm = R"(name = "arm"
gravity = [0, 0, -1.62]
[[link]]
name = "upper"
joint = "shoulder"
mass = 3
com = [0.5, 0, 0]
inertia = { xx = 1, yy = 2, zz = 3 }
inertia_about = "origin"
viscous = 0.5
limits = { lower = -1, upper = 1 }
[link.motor]
mass = 0.25
inertia = 1e-4
gear_ratio = 100
position = [0, 0, 0.1]
[[link]]
name = "lower"
joint = "elbow"
mass = 1
[tip]
link = "upper"
[payload]
link = "lower"
mass = 7
)";

class TomlOverlay : public RobotFiles {
 protected:
  Robot over_arm(const std::string& text, const ReadOptions& options = {}) {
    write("arm.toml", kOverlaidArm);
    return read("over.toml", "robot = \"arm.toml\"\n" + text, options);
  }
  Robot over_urdf(const std::string& elements, const std::string& text, const ReadOptions& options = {}) {
    write("arm.urdf", one_joint_urdf("revolute", elements));
    return read("over.toml", "urdf = \"arm.urdf\"\n" + text, options);
  }
};

TEST_F(TomlOverlay, AddsToAUrdf) {
  write("arm.urdf", one_joint_urdf("revolute", R"(<dynamics damping="1" friction="2"/><limit lower="-1" upper="1"
      velocity="2" effort="3"/>)",
                                   R"(<link name="h"/><joint name="k" type="floating"><parent link="arm"/>
      <child link="h"/></joint>)"));
  const Robot robot = read("arm.toml", R"(urdf = "arm.urdf"
name = "my arm"
fixed = ["k"]
gravity = [0, 0, -1.62]
[[joint]]
name = "j"
viscous = 0.5
limits = { velocity = 5 }
[joint.motor]
inertia = 1e-5
gear_ratio = 50
[tip]
link = "h"
)");
  EXPECT_EQ(robot.name, "my arm");
  EXPECT_TRUE(robot.gravity[2].is_equal(Number(-162) / 100));
  const Joint& joint = robot.joints[0];
  EXPECT_TRUE(joint.viscous.number.is_equal(Number(1) / 2));
  EXPECT_TRUE(joint.coulomb.number.is_equal(2));  // of the URDF
  EXPECT_TRUE(joint.limits.velocity->number.is_equal(5));
  EXPECT_TRUE(joint.limits.upper->number.is_equal(1));
  EXPECT_TRUE(joint.motor->inertia_axial.number.is_equal(exact_decimal("0.00001")));
  EXPECT_EQ(robot.links[static_cast<std::size_t>(robot.tip)].name, "h");
}

TEST_F(TomlOverlay, ReadsAnotherToml) {
  const Robot robot = over_arm("");
  EXPECT_EQ(robot.name, "arm");
  EXPECT_EQ(robot.files.size(), 2U);
  EXPECT_TRUE(robot.gravity[2].is_equal(Number(-162) / 100));
  EXPECT_EQ(robot.tip, 1);
  EXPECT_EQ(robot.links[2].inertials.size(), 2U);  // with the payload
  EXPECT_TRUE(robot.joints[0].motor->gear_ratio.number.is_equal(100));
}

TEST_F(TomlOverlay, RobotNamesAUrdfToo) {
  write("arm.urdf", one_joint_urdf("revolute", R"(<dynamics damping="1"/>)"));
  const Robot robot = read("over.toml", "robot = \"arm.urdf\"\n[[joint]]\nname = \"j\"\ncoulomb = 2\n");
  EXPECT_TRUE(robot.joints[0].viscous.number.is_equal(1));
  EXPECT_TRUE(robot.joints[0].coulomb.number.is_equal(2));
}

TEST_F(TomlOverlay, MayBeOverAnOverlay) {
  write("arm.toml", kOverlaidArm);
  write("middle.toml", "robot = \"arm.toml\"\n[[joint]]\nname = \"elbow\"\nviscous = 2\ncoulomb = 3\n");
  const Robot robot = read("over.toml", "robot = \"middle.toml\"\n[[joint]]\nname = \"elbow\"\nviscous = 4\n");
  EXPECT_TRUE(robot.joints[1].viscous.number.is_equal(4));
  EXPECT_TRUE(robot.joints[1].coulomb.number.is_equal(3));
}

TEST_F(TomlOverlay, ALinkRowReplacesTheWholeBody) {
  const Robot robot = over_arm(R"([[link]]
name = "upper"
mass = 4
com = [0, 0.25, 0]
inertia = { xx = 5, yy = 5, zz = 5 }
inertia_about = "com"
[[link]]
name = "lower"
mass = 0
)");
  const Inertial& upper = robot.links[1].inertials.at(0);
  EXPECT_TRUE(upper.mass.number.is_equal(4));
  EXPECT_TRUE(upper.centre_of_mass[0].is_zero());
  EXPECT_TRUE(upper.centre_of_mass[1].is_equal(Number(1) / 4));
  EXPECT_TRUE(upper.tensor[0][0].is_equal(5));
  EXPECT_EQ(upper.about, Inertial::About::centre_of_mass);
  EXPECT_TRUE(robot.links[2].inertials.at(0).mass.number.is_zero());
  EXPECT_TRUE(robot.joints[0].viscous.number.is_equal(Number(1) / 2));  // the joint stays
}

TEST_F(TomlOverlay, ALinkRowLeavesTheFrameOfTheUrdfsInertiaBehind) {
  write("arm.urdf", R"(<robot name="r"><link name="base"/><link name="arm"><inertial><origin xyz="1 2 3" rpy="0 0 1"/>
      <mass value="2"/><inertia ixx="1" iyy="1" izz="1"/></inertial></link>
      <joint name="j" type="revolute"><parent link="base"/><child link="arm"/></joint></robot>)");
  const Robot robot = read("over.toml", R"(robot = "arm.urdf"
[[link]]
name = "arm"
mass = 1
com = [0, 0, 1]
inertia = { xx = 1, yy = 1, zz = 1 }
inertia_about = "com"
)");
  ASSERT_EQ(robot.links[1].inertials.size(), 1U);
  EXPECT_TRUE(robot.links[1].inertials[0].frame.displacements.empty());
  EXPECT_TRUE(robot.links[1].inertials[0].centre_of_mass[2].is_equal(1));
}

TEST_F(TomlOverlay, AMotorChangesOnlyWhatIsGiven) {
  const Robot robot = over_arm("[[joint]]\nname = \"shoulder\"\nmotor = { inertia = 2e-4, carrier = \"upper\" }\n");
  const Motor& motor = robot.joints[0].motor.value();
  EXPECT_TRUE(motor.inertia_axial.number.is_equal(exact_decimal("2e-4")));
  EXPECT_EQ(motor.carrier, 1);
  EXPECT_TRUE(motor.mass.number.is_equal(Number(1) / 4));
  EXPECT_TRUE(motor.gear_ratio.number.is_equal(100));
  EXPECT_TRUE(motor.position[2].is_equal(Number(1) / 10));
}

TEST_F(TomlOverlay, TipAndPayloadReplaceThoseOfTheFile) {
  const Robot robot = over_arm("tip = { link = \"lower\" }\npayload = { mass = 5 }\n");
  EXPECT_EQ(robot.tip, 2);
  ASSERT_EQ(robot.links[2].inertials.size(), 2U);
  EXPECT_TRUE(robot.links[2].inertials[1].mass.number.is_equal(5));
}

constexpr const char* kRotor = R"(<drake:rotor_inertia value="1e-4"/><drake:gear_ratio value="50"/>)";

TEST_F(TomlOverlay, AMotorTakesThePlaceOfTheUrdfsRotor) {
  const Robot robot = over_urdf(kRotor, "[[joint]]\nname = \"j\"\nmotor = { inertia = 1e-5, gear_ratio = 100 }\n");
  EXPECT_TRUE(robot.joints[0].armature.number.is_zero());
  EXPECT_TRUE(robot.joints[0].motor->inertia_axial.number.is_equal(exact_decimal("1e-5")));
  ASSERT_EQ(diagnostics_.all().size(), 1U);
  EXPECT_EQ(diagnostics_.all()[0].severity, Severity::note);
}

TEST_F(TomlOverlay, AnArmatureTakesThePlaceOfTheUrdfsRotor) {
  const Robot robot = over_urdf(kRotor, "[[joint]]\nname = \"j\"\narmature = 2\n");
  EXPECT_TRUE(robot.joints[0].armature.number.is_equal(2));
  EXPECT_TRUE(diagnostics_.all().empty());
}

TEST_F(TomlOverlay, AnArmatureStandsForTheInertiaThatAMotorDoesNotGive) {
  const Robot robot = over_urdf(R"(<dynamics armature="0.5"/>)", "[[joint]]\nname = \"j\"\nmotor = { mass = 2 }\n");
  EXPECT_TRUE(robot.joints[0].armature.number.is_equal(Number(1) / 2));
  EXPECT_TRUE(robot.joints[0].motor->mass.number.is_equal(2));
}

TEST_F(TomlOverlay, ServesAJointThatIsHeldToo) {
  ReadOptions options;
  options.scene.locked = {{"elbow"}};
  const std::string text = "[[joint]]\nname = \"elbow\"\nviscous = 1\nmotor = { mass = 2 }\n";
  EXPECT_EQ(moving_joints(over_arm(text, options)).size(), 1U);
  write("two.urdf", one_joint_urdf("revolute", "", R"(<link name="hand"/><joint name="elbow" type="revolute">
      <parent link="arm"/><child link="hand"/></joint>)"));
  const Robot robot = read("over.toml", "urdf = \"two.urdf\"\n" + text, options);
  EXPECT_EQ(moving_joints(robot).size(), 1U);
  EXPECT_EQ(robot.links[1].inertials.size(), 2U);  // with the rotor that no longer turns
}

TEST_F(TomlOverlay, SaysNothingOfFrictionWhereTheTypeOfTheJointIsNotSupported) {
  write("arm.urdf", one_joint_urdf("universal", ""));
  const auto path = write("over.toml", "urdf = \"arm.urdf\"\n[[joint]]\nname = \"j\"\nviscous = 1\n");
  EXPECT_FALSE(read_robot(path, {}, diagnostics_).has_value());
  EXPECT_TRUE(diagnostics_.only_unsupported());
}

}  // namespace
}  // namespace flatdyn
