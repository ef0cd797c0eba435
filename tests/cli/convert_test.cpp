// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/program.hpp"

namespace flatdyn::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class Convert : public ::testing::Test {
 protected:
  // Converts a file, which must be read back as the same mechanism, exactly.
  std::string exact(const std::string& arguments, const std::string& output) {
    const Outcome outcome = run_flatdyn("convert " + arguments + " -o " + scratch.path(output));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("read back: the same mechanism, exactly")) << arguments;
    return scratch.read(output);
  }

  Scratch scratch;
};

TEST_F(Convert, WritesUrdfAsUrdfAndToml) {
  for (const char* robot : {"robots/panda.urdf", "robots/ur5.urdf"}) {
    exact(robot, "again.urdf");
    exact(robot, "again.toml");
    exact(scratch.path("again.toml"), "back.urdf");
  }
}

// A TOML file goes to stdout, and nothing else.
TEST_F(Convert, WritesToStandardOutput) {
  for (const char* robot : {"robots/puma560.toml", "robots/ur5.urdf"}) {
    exact(robot, "again.toml");
    const Outcome outcome = run_flatdyn(std::string("convert ") + robot + " -o -");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, scratch.read("again.toml"));
  }
  EXPECT_EQ(run_flatdyn("convert robots/ur5.urdf -o - --json").code, 2);
}

TEST_F(Convert, WritesDhTables) {
  for (const char* robot : {"puma560", "rx90"}) {
    exact("robots/" + std::string(robot) + ".toml", "again.toml");
  }
}

TEST_F(Convert, WritesSprings) {
  scratch.write("r.toml",
                "name = \"r\"\n[[link]]\njoint = \"j\"\nmass = 1\ncom = [1, 0, 0]\nstiffness = 2.5\n"
                "spring_reference = -0.25\n");
  EXPECT_THAT(exact(scratch.path("r.toml"), "a.toml"), HasSubstr("stiffness = 2.5\nspring_reference = -0.25\n"));
  EXPECT_THAT(exact(scratch.path("r.toml"), "a.urdf"),
              HasSubstr("<gazebo reference=\"j\">\n    <springStiffness>2.5</springStiffness>\n"
                        "    <springReference>-0.25</springReference>\n  </gazebo>\n"));
  exact(scratch.path("a.urdf"), "b.toml");
}

TEST_F(Convert, WritesTendons) {
  scratch.write(
      "r.toml",
      "name = \"r\"\n[[link]]\njoint = \"i\"\nmass = 1\ncom = [1, 0, 0]\n[[link]]\njoint = \"j\"\nmass = 1\n"
      "com = [1, 0, 0]\n[[tendon]]\nname = \"t\"\nlength = \"2*i - 1/3*j\"\nstiffness = 2.5\narmature = \"a\"\n");
  EXPECT_THAT(
      exact(scratch.path("r.toml"), "a.toml"),
      HasSubstr("[[tendon]]\nname = \"t\"\nlength = \"(2)*'i' + (-1/3)*'j'\"\nstiffness = 2.5\narmature = \"a\"\n"));
  EXPECT_THAT(run_flatdyn("convert " + scratch.path("r.toml") + " -o " + scratch.path("a.urdf")).err,
              HasSubstr("a URDF cannot say a tendon, \"t\""));
}

TEST_F(Convert, KeepsDecimalsAndAnglesAsTheyAre) {
  scratch.write("r.urdf", R"(<robot name="r"><link name="base"/><link name="arm"><inertial>
    <origin xyz="0.1 0 -1e-3"/><mass value="2.50"/><inertia ixx="1e-9" iyy="2" izz="2" ixy="0" ixz="0" iyz="0"/>
    </inertial><visual/></link><joint name="j" type="revolute"><origin rpy="0 1.5708 0.3"/><parent link="base"/>
    <child link="arm"/><axis xyz="0 0 1"/><limit lower="-1" upper="1.25"/></joint></robot>)");
  const std::string urdf = exact(scratch.path("r.urdf"), "a.urdf");
  EXPECT_THAT(urdf, HasSubstr("<origin rpy=\"0 1.5707963267948966193 0.3\"/>"));
  EXPECT_THAT(urdf, HasSubstr("<origin xyz=\"0.1 0 -0.001\"/>"));
  EXPECT_THAT(urdf, HasSubstr("<mass value=\"2.5\"/>"));
  EXPECT_THAT(urdf, HasSubstr("ixx=\"1e-9\""));
  EXPECT_THAT(urdf, HasSubstr("<limit lower=\"-1\" upper=\"1.25\"/>"));
  EXPECT_THAT(urdf, Not(HasSubstr("visual")));
  EXPECT_THAT(exact(scratch.path("r.urdf"), "a.toml"), HasSubstr("rpy = [0, \"1/2*pi\", \"0.3\"]"));
}

TEST_F(Convert, RoundsWhatIsNoDecimalAndSaysSo) {
  scratch.write("r.sdf", R"(<sdf version="1.9"><model name="r"><link name="base"/>
    <link name="arm"><pose>0 0 1 0.3 0 0</pose></link><link name="hand"><pose>0 0.5 1 0.3 0 0</pose></link>
    <joint name="j" type="revolute"><parent>base</parent><child>arm</child><axis><xyz>0 0 1</xyz></axis></joint>
    <joint name="k" type="revolute"><parent>arm</parent><child>hand</child><axis><xyz>0 0 1</xyz></axis></joint>
    </model></sdf>)");
  const Outcome outcome = run_flatdyn("convert " + scratch.path("r.sdf") + " -o " + scratch.path("r.urdf"));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("numbers are no finite decimals and are rounded to 25 digits"));
  EXPECT_THAT(outcome.out, HasSubstr("read back: torques at random states differ by at most"));
}

TEST_F(Convert, WritesLoopsAndTheirAssembly) {
  EXPECT_THAT(exact("robots/four_bar.toml", "a.toml"), HasSubstr("dependent = ["));
  exact(scratch.path("a.toml"), "b.toml");
  EXPECT_EQ(scratch.read("a.toml"), scratch.read("b.toml"));
}

// A keyframe's joints are in the order of its bodies, those of a table of TOML in no order.
TEST_F(Convert, WritesTheAssemblyOfAKeyframe) {
  scratch.write("r.xml", R"(<mujoco><compiler angle="radian"/><worldbody><body name="base"><freejoint/><geom size=".2"/>
    <body name="t1"><joint name="z" axis="0 1 0"/><geom size=".1"/>
      <body name="s1" pos=".09 0 0"><joint name="y" axis="0 1 0"/><geom size=".1"/></body></body>
    <body name="t2"><joint name="b" axis="0 1 0"/><geom size=".1"/>
      <body name="s2" pos=".09 0 0"><joint name="a" axis="0 1 0"/><geom size=".1"/></body></body></body></worldbody>
    <actuator><motor joint="z"/><motor joint="b"/></actuator>
    <equality><connect body1="s1" body2="s2" anchor=".162 0 0"/></equality>
    <keyframe><key name="home" qpos="0 0 1 1 0 0 0 .785 1.189 2.356 -1.189"/></keyframe></mujoco>)");
  const std::string text = exact(scratch.path("r.xml") + " --keyframe home", "a.toml");
  EXPECT_THAT(text, HasSubstr("\"y\" = \"1.189\""));
}

TEST_F(Convert, WritesSymbols) {
  EXPECT_THAT(exact("robots/planar_2r.toml", "a.toml"), HasSubstr("a_1"));
  exact(scratch.path("a.toml"), "b.toml");
  scratch.write("r.toml",
                "name = \"r\"\n[[link]]\nxyz = [\"Pi_x\", 0, \"2*a/b\"]\nmass = \"m\"\n"
                "com = [1, 0, \"c^2/b\"]\n[[link]]\nxyz = [\"l - z/2\", \"(b - a)*pi\", \"-a*(c + b)/3\"]\nmass = 1\n");
  EXPECT_THAT(exact(scratch.path("r.toml"), "c.toml"),
              AllOf(HasSubstr("[\"Pi_x\", 0, \"2*a*b^(-1)\"]"), HasSubstr("com = [1, 0, \"b^(-1)*c^2\"]"),
                    HasSubstr("[\"l - 1/2*z\", \"b*pi - a*pi\", \"-1/3*a*b - 1/3*a*c\"]")));
}

TEST_F(Convert, WritesMultiplesOfPiInCouplings) { exact("robots/parallelogram.toml", "a.toml"); }

TEST_F(Convert, RefusesWhatTheFormatCannotSay) {
  const auto refused = [this](const std::string& arguments) {
    const Outcome outcome = run_flatdyn("convert " + arguments + " -o " + scratch.path("r.urdf"));
    EXPECT_EQ(outcome.code, 4) << arguments;
    EXPECT_TRUE(scratch.is_empty()) << arguments;
    return outcome.err;
  };
  EXPECT_THAT(refused("robots/panda.urdf --gravity 0,0,-1.62"), HasSubstr("a URDF cannot say which gravity there is"));
  EXPECT_THAT(refused("robots/pendulum_motor.toml"), HasSubstr("a URDF cannot say what the motor of joint"));
  EXPECT_THAT(refused("robots/panda.urdf --fix panda_joint1=0.5"), HasSubstr("the position of a joint that is held"));
  EXPECT_THAT(refused("robots/four_bar.toml"), HasSubstr("a URDF cannot say how chains are closed"));
  EXPECT_THAT(refused("robots/planar_2r.toml"), HasSubstr("a URDF cannot say symbols such as"));
}

TEST_F(Convert, NeedsANameThatSaysTheFormat) {
  const Outcome outcome = run_flatdyn("convert robots/panda.urdf -o " + scratch.path("r.xml"));
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("must end in .urdf or .toml"));
}

}  // namespace
}  // namespace flatdyn::testing
