// SPDX-License-Identifier: GPL-2.0-or-later
// Whatever stands in a URDF is read, noted or refused, and at its own line: elements that are not known, known ones in
// places or letters in which they are not read, and words that other formats and programs have.
#include <gmock/gmock.h>

#include <map>

#include "robot/model/coupling.hpp"
#include "unit/input/robot_file.hpp"

namespace flatdyn {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// A chain of two joints, j and k, with a place for more in each of its elements.
std::string with(const std::string& place, const std::string& text) {
  const auto at = [&](const std::string& here) { return here == place ? text : std::string(); };
  return "<robot name=\"r\"><link name=\"base\"/>" + at("robot") + "<link name=\"arm\">" + at("link") +
         "<inertial><mass value=\"2\">" + at("mass") + "</mass><inertia ixx=\"1\" iyy=\"1\" izz=\"1\"/>" +
         at("inertial") + "</inertial></link><link name=\"hand\"><inertial><mass value=\"2\"/>" +
         "<inertia ixx=\"1\" iyy=\"1\" izz=\"1\"/></inertial></link>" +
         "<joint name=\"j\" type=\"continuous\"><parent link=\"base\">" + at("parent") +
         "</parent><child link=\"arm\"/><axis xyz=\"0 0 1\">" + at("axis") + "</axis>" + at("joint") + "</joint>" +
         "<joint name=\"k\" type=\"continuous\"><parent link=\"arm\"/><child link=\"hand\"/><origin xyz=\"1 0 0\"/>" +
         "<axis xyz=\"0 0 1\"/>" + at("second joint") + "</joint></robot>";
}

enum class Answer { note, warning, error, unsupported };

struct Unread {
  const char* name;
  const char* place;
  const char* text;
  Answer answer;
  const char* says;
};

class UrdfUnread : public RobotFiles, public ::testing::WithParamInterface<Unread> {};

TEST_P(UrdfUnread, IsAnswered) {
  const Unread& it = GetParam();
  const auto path = write("r.urdf", with(it.place, "\n" + std::string(it.text)));
  const bool is_read = read_robot(path, {}, diagnostics_).has_value();
  EXPECT_EQ(is_read, it.answer == Answer::note || it.answer == Answer::warning);
  const Severity severity = it.answer == Answer::note      ? Severity::note
                            : it.answer == Answer::warning ? Severity::warning
                                                           : Severity::error;
  std::string all;
  bool found = false;
  for (const Diagnostic& each : diagnostics_.all()) {
    all += to_string(each) + "\n";
    EXPECT_FALSE(each.hint.empty()) << to_string(each);
    found = found ||
            (each.severity == severity && (each.place.line == 2 || it.text[0] != '<') &&
             each.unsupported == (it.answer == Answer::unsupported) && each.message.find(it.says) != std::string::npos);
  }
  EXPECT_TRUE(found) << all;
}

const Unread kElements[] = {
    {"AnUnknownOne", "joint", "<spin_limits a=\"1\"/>", Answer::note, "unknown element <spin_limits>"},
    {"AnUnknownOneOfRobot", "robot", "<footprint r=\"1\"/>", Answer::note, "unknown element <footprint>"},
    {"Text", "link", "2.5", Answer::note, "the text \"2.5\" is not read"},
    {"AxisInCapitals", "joint", "<AXIS xyz=\"0 1 0\"/>", Answer::error, "unknown element <AXIS>"},
    {"InertialInCapitals", "link", "<INERTIAL/>", Answer::error, "unknown element <INERTIAL>"},
    {"DynamicsInCapitals", "joint", "<Dynamics damping=\"1\"/>", Answer::error, "unknown element <Dynamics>"},
    {"MimicInCapitals", "second joint", "<MIMIC joint=\"j\"/>", Answer::error, "unknown element <MIMIC>"},
    {"LoopInCapitals", "robot", "<LOOP type=\"revolute\"/>", Answer::error, "unknown element <LOOP>"},
    {"OriginWithPrefix", "joint", "<x:origin xyz=\"0 0 1\"/>", Answer::error, "unknown element <x:origin>"},
    {"DampingInCapitals", "joint", "<dynamics friction=\"0\" DAMPING=\"1\"/>", Answer::error, "\"DAMPING\""},
    {"MisspeltDrake", "joint", "<drake:rotor_inertai value=\"1\"/>", Answer::error, "<drake:rotor_inertai>"},
    {"AxisInRobot", "robot", "<axis xyz=\"0 1 0\"/>", Answer::error, "robot: <axis> has no effect here"},
    {"DynamicsInRobot", "robot", "<dynamics damping=\"1\"/>", Answer::error, "robot: <dynamics> has no effect here"},
    {"InertialInRobot", "robot", "<inertial><mass value=\"1\"/></inertial>", Answer::error, "<inertial> has no effect"},
    {"OriginInRobot", "robot", "<origin xyz=\"0 0 1\"/>", Answer::error, "robot: <origin> has no effect here"},
    {"MimicInRobot", "robot", "<mimic joint=\"j\"/>", Answer::error, "robot: <mimic> has no effect here"},
    {"LinksInAGroup", "robot", "<group><link name=\"l\"><inertial/></link></group>", Answer::error,
     "<link> in <group> is not read"},
    {"LinksInAModel", "robot", "<model><a><link name=\"new\"/></a></model>", Answer::error, "<link> in <model>"},
    {"NamesInAGroup", "robot", "<group><link name=\"arm\"/><joint name=\"j\"/></group>", Answer::note, "<group>"},
    {"RobotInRobot", "robot", "<robot name=\"b\"><joint name=\"z\" type=\"fixed\"/></robot>", Answer::error,
     "<joint> in <robot> is not read"},
    {"OriginInMass", "mass", "<origin xyz=\"0 0 1\"/>", Answer::error, "<origin> has no effect here"},
    {"AxisInParent", "parent", "<axis xyz=\"0 0 1\"/>", Answer::error, "<axis> has no effect here"},
    {"LimitInAxis", "axis", "<limit lower=\"0\"/>", Answer::error, "<limit> has no effect here"},
    {"MassInVisual", "link", "<visual><mass value=\"1\"/></visual>", Answer::error, "<mass> in <visual>"},
    {"Pose", "inertial", "<pose>0 0 1 0 0 0</pose>", Answer::error, "<pose> is not read from a URDF"},
    {"PoseOfZeros", "inertial", "<pose>0 0 0 0 0 0</pose>", Answer::note, "<pose>"},
    {"Com", "inertial", "<com xyz=\"0 0 1\"/>", Answer::error, "<com> is not read from a URDF"},
    {"CenterOfMass", "inertial", "<center_of_mass>0 0 1</center_of_mass>", Answer::error, "<center_of_mass>"},
    {"Cog", "link", "<cog xyz=\"0 0 1\"/>", Answer::error, "<cog> is not read from a URDF"},
    {"Include", "robot", "<include><uri>model://hand</uri></include>", Answer::error, "<include> is not read"},
    {"XInclude", "robot", "<xi:include href=\"hand.urdf\"/>", Answer::error, "<xi:include> is not read"},
    {"Import", "robot", "<import file=\"hand.urdf\"/>", Answer::error, "<import> is not read"},
    {"Spring", "joint", "<spring stiffness=\"10\"/>", Answer::unsupported, "<spring> is not known"},
    {"Viscous", "joint", "<viscous>3</viscous>", Answer::unsupported, "<viscous> is not known"},
    {"JointDynamics", "joint", "<joint_dynamics damping=\"3\"/>", Answer::unsupported, "<joint_dynamics>"},
    {"Rotor", "joint", "<rotor><inertia>1</inertia></rotor>", Answer::unsupported, "<rotor> is not known"},
    {"Motor", "joint", "<motor inertia=\"1\"/>", Answer::unsupported, "<motor> is not known"},
    {"ReflectedInertia", "joint", "<reflected_inertia>1</reflected_inertia>", Answer::unsupported,
     "<reflected_inertia>"},
    {"Payload", "robot", "<payload mass=\"1\"/>", Answer::unsupported, "<payload> is not known"},
    {"Gravity", "robot", "<gravity>0 0 -1.6</gravity>", Answer::unsupported, "<gravity> is not known"},
    {"Gear", "robot", "<gear ratio=\"6\"/>", Answer::unsupported, "<gear> is not known"},
    {"ClosedLoop", "robot", "<closed_loop a=\"arm\" b=\"base\"/>", Answer::unsupported, "<closed_loop> is not known"},
    {"Equality", "robot", "<equality><weld body1=\"arm\"/></equality>", Answer::unsupported, "<equality> is not known"},
    {"NoSpring", "joint", "<spring stiffness=\"0\"/>", Answer::note, "unknown element <spring>"},
    {"MotorController", "joint", "<motor_controller id=\"1\"/>", Answer::note, "<motor_controller>"},
    {"Cable", "robot", "<cable spring_k=\"100\"><terminator/></cable>", Answer::unsupported,
     "<cable> is not supported"},
    {"ForceElement", "robot", "<force_element name=\"f\"/>", Answer::unsupported, "<force_element"},
};

const Unread kRotors[] = {
    {"MisspeltMotorInertia", "robot",
     "<transmission name=\"t\"><joint name=\"j\"/><actuator><motorInerta>1</motorInerta></actuator></transmission>",
     Answer::error, "unknown element <motorInerta>"},
    {"ActuatorInCapitals", "robot",
     "<transmission name=\"t\"><joint name=\"j\"/><Actuator><motorInertia>1</motorInertia></Actuator></transmission>",
     Answer::error, "unknown element <Actuator>"},
    {"InertiaOfARotor", "robot",
     "<transmission name=\"t\"><joint name=\"j\"/><actuator><rotor><inertia>1</inertia></rotor></actuator>"
     "</transmission>",
     Answer::unsupported, "<rotor> is not known"},
    {"NoJoint", "robot", "<transmission name=\"t\"><actuator><motorInertia>1</motorInertia></actuator></transmission>",
     Answer::error, "has a rotor inertia and names no joint"},
    {"JointName", "robot",
     "<transmission name=\"t\"><jointName>j</jointName><actuator><motorInertia>1</motorInertia></actuator>"
     "</transmission>",
     Answer::error, "has a rotor inertia and names no joint"},
    {"OtherAttribute", "robot",
     "<transmission name=\"t\"><joint name=\"j\"/><actuator rotorInertia=\"1\"/></transmission>", Answer::error,
     "unknown attribute \"rotorInertia\""},
    {"AttributeOfDynamics", "joint", "<dynamics damping=\"1\" friction=\"0\" rotor_inertia=\"1\"/>", Answer::error,
     "unknown attribute \"rotor_inertia\""},
    {"DynamicsInRos2Control", "robot",
     "<ros2_control><joint name=\"j\"><dynamics damping=\"1\"/></joint></ros2_control>", Answer::unsupported,
     "<dynamics> in <ros2_control>"},
    {"InRos2Control", "robot",
     "<ros2_control><joint name=\"j\"><param name=\"rotor_inertia\">1</param></joint></ros2_control>",
     Answer::unsupported, "in <ros2_control> is not supported"},
    {"RatioInRos2Control", "robot",
     "<ros2_control><joint name=\"j\"><param name=\"gear_ratio\">50</param></joint></ros2_control>", Answer::note,
     "param \"gear_ratio\" is not read"},
    {"LeftActuator", "robot",
     "<transmission name=\"t\"><leftActuator><motorInertia>1</motorInertia></leftActuator><joint name=\"j\"/>"
     "</transmission>",
     Answer::error, "<motorInertia> in <leftActuator> is not read"},
};

const Unread kFollowers[] = {
    {"CouplingsAttribute", "robot",
     "<coupling ratio=\"6\"><predecessor link=\"arm\"/><successor link=\"hand\"/></coupling>", Answer::error,
     "unknown attribute \"ratio\""},
    {"TwoRatios", "robot",
     "<coupling><predecessor link=\"arm\"/><successor link=\"hand\"/><ratio value=\"1\"/><ratio "
     "value=\"2\"/></coupling>",
     Answer::error, "has two <ratio> elements"},
    {"MisspeltMultiplier", "robot",
     "<gazebo><plugin name=\"m\"><joint>j</joint><mimicJoint>k</mimicJoint><multipler>2</multipler></plugin></gazebo>",
     Answer::error, "unknown element <multipler>"},
    {"MultiplierInCapitals", "robot",
     "<gazebo><plugin "
     "name=\"m\"><joint>j</joint><mimicJoint>k</mimicJoint><Multiplier>2</Multiplier></plugin></gazebo>",
     Answer::error, "unknown element <Multiplier>"},
    {"RatioOfAPlugin", "robot",
     "<gazebo><plugin name=\"m\"><joint>j</joint><mimicJoint>k</mimicJoint><ratio>2</ratio></plugin></gazebo>",
     Answer::error, "unknown element <ratio>"},
    {"AttributeOfMimicJoint", "robot",
     "<gazebo><plugin name=\"m\"><joint>j</joint><mimicJoint multiplier=\"2\">k</mimicJoint></plugin></gazebo>",
     Answer::error, "unknown attribute \"multiplier\""},
    {"TwoMultipliers", "robot",
     "<gazebo><plugin name=\"m\"><joint>j</joint><mimicJoint>k</mimicJoint><multiplier>2</multiplier>"
     "<multiplier>3</multiplier></plugin></gazebo>",
     Answer::error, "multiplier is given twice"},
    {"MimicJointOfOtherLetters", "robot",
     "<gazebo><plugin name=\"grip\"><joint>j</joint><mimic_joint>k</mimic_joint></plugin></gazebo>",
     Answer::unsupported, "in a form that is not known"},
    {"Follow", "robot", "<gazebo><plugin name=\"grip\"><follow joint=\"j\"/></plugin></gazebo>", Answer::unsupported,
     "in a form that is not known"},
    {"FollowInAJoint", "second joint", "<follow joint=\"j\"/>", Answer::unsupported, "<follow> is not known"},
    {"MisspeltParameter", "robot",
     "<ros2_control><joint name=\"k\"><param name=\"mimic\">j</param><param name=\"mulitplier\">2</param></joint>"
     "</ros2_control>",
     Answer::error, "unknown parameter \"mulitplier\""},
    {"MimicParameterInCapitals", "robot",
     "<ros2_control><joint name=\"k\"><param name=\"Mimic\">j</param></joint></ros2_control>", Answer::error,
     "unknown parameter \"Mimic\""},
    {"TwoParameters", "robot",
     "<ros2_control><joint name=\"k\"><param name=\"mimic\">j</param><param name=\"multiplier\">2</param>"
     "<param name=\"multiplier\">3</param></joint></ros2_control>",
     Answer::error, "multiplier is given twice"},
    {"MimicInRos2Control", "robot", "<ros2_control><joint name=\"k\"><mimic joint=\"j\"/></joint></ros2_control>",
     Answer::unsupported, "in a form that is not known"},
    {"Polycoeff", "robot", "<mujoco><equality><joint joint1=\"k\" joint2=\"j\" polycoeff=\"0 2\"/></equality></mujoco>",
     Answer::error, "unknown attribute \"polycoeff\""},
    {"JointInAModel", "robot",
     "<gazebo><model><joint name=\"l\"><parent>arm</parent><child>base</child></joint></model></gazebo>",
     Answer::unsupported, "<joint name=\"l\"> in <gazebo>"},
    {"LoopInGazebo", "robot", "<gazebo><loop type=\"revolute\"/></gazebo>", Answer::unsupported, "<loop> in <gazebo>"},
    {"MujocoInGazebo", "robot",
     "<gazebo><mujoco><equality><joint joint1=\"k\" joint2=\"j\"/></equality></mujoco></gazebo>", Answer::unsupported,
     "<mujoco> in <gazebo>"},
    {"MimicJointInRobot", "robot", "<mimic_joint a=\"j\" b=\"k\"/>", Answer::unsupported, "<mimic_joint> is not known"},
};

const Unread kLoops[] = {
    {"TwoOrigins", "robot",
     "<loop type=\"revolute\"><predecessor link=\"hand\"><origin xyz=\"1 0 0\"/><origin xyz=\"2 0 0\"/></predecessor>"
     "<successor link=\"base\"/><axis xyz=\"0 0 1\"/></loop>",
     Answer::error, "has two <origin> elements"},
    {"OriginBesideOrigin", "robot",
     "<loop type=\"revolute\"><predecessor link=\"hand\"><origin xyz=\"1 0 0\"/></predecessor>"
     "<predecessor_origin xyz=\"2 0 0\"/><successor link=\"base\"/><axis xyz=\"0 0 1\"/></loop>",
     Answer::error, "has both <predecessor_origin> and an <origin>"},
    {"AxisBesideAxis", "robot",
     "<constraint type=\"revolute\"><parent link=\"hand\"/><child link=\"base\"/><axis xyz=\"0 0 1\"/>"
     "<parent_axis xyz=\"0 1 0\"/></constraint>",
     Answer::error, "has both <axis> and <parent_axis>, which differ"},
    {"PointInPredecessor", "robot",
     "<loop type=\"revolute\"><predecessor link=\"hand\" xyz=\"1 0 0\"/><successor link=\"base\"/><axis xyz=\"0 0 1\"/>"
     "</loop>",
     Answer::error, "predecessor: unknown attribute \"xyz\""},
    {"TextInPredecessor", "robot",
     "<loop type=\"revolute\"><predecessor link=\"hand\">1 0 0</predecessor><successor link=\"base\"/>"
     "<axis xyz=\"0 0 1\"/></loop>",
     Answer::error, "the text \"1 0 0\" is not read"},
};

const Unread kOfSimulators[] = {
    {"TurnGravityOff", "robot", "<gazebo reference=\"arm\"><turnGravityOff>true</turnGravityOff></gazebo>",
     Answer::note, "turnGravityOff (true) is not read"},
    {"GravityOff", "robot", "<gazebo reference=\"arm\"><gravity>0</gravity></gazebo>", Answer::note, "gravity (0)"},
    {"VelocityDecay", "robot",
     "<gazebo reference=\"arm\"><velocity_decay><linear>0.1</linear></velocity_decay></gazebo>", Answer::note,
     "linear (0.1) is not read"},
    {"DampingFactor", "robot", "<gazebo reference=\"arm\"><dampingFactor>0.1</dampingFactor></gazebo>", Answer::note,
     "dampingFactor (0.1)"},
    {"Damping", "robot", "<gazebo reference=\"j\"><axis><dynamics><damping>5</damping></dynamics></axis></gazebo>",
     Answer::note, "damping (5) is not read"},
    {"Mass", "robot", "<gazebo><link name=\"x\"><inertial><mass>5</mass></inertial></link></gazebo>", Answer::note,
     "mass (5) is not read"},
    {"SpringOfALink", "robot", "<gazebo reference=\"arm\"><spring_stiffness>5</spring_stiffness></gazebo>",
     Answer::error, "there is no joint \"arm\" for this spring"},
    {"SpringOfNothing", "robot", "<gazebo><springStiffness>5</springStiffness></gazebo>", Answer::unsupported,
     "springs are not read here"},
    {"SpringInDynamics", "robot",
     "<gazebo reference=\"j\"><axis><dynamics><spring_stiffness>5</spring_stiffness></dynamics></axis></gazebo>",
     Answer::unsupported, "springs are not read here"},
    {"MujocoGravity", "robot", "<mujoco><option gravity=\"0 0 -1.6\"/></mujoco>", Answer::note, "option gravity"},
    {"TotalMass", "robot", "<mujoco><compiler settotalmass=\"5\"/></mujoco>", Answer::note, "compiler settotalmass"},
    {"InertiaFromGeom", "robot", "<mujoco><compiler inertiafromgeom=\"true\"/></mujoco>", Answer::note,
     "compiler inertiafromgeom"},
    {"DefaultJoint", "robot", "<mujoco><default><joint armature=\"0.1\" damping=\"1\"/></default></mujoco>",
     Answer::note, "default joint armature (0.1)"},
    {"InertiaScaling", "link", "<contact><inertia_scaling value=\"3\"/></contact>", Answer::note, "<inertia_scaling>"},
};

std::string name_of_unread(const ::testing::TestParamInfo<Unread>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Elements, UrdfUnread, ::testing::ValuesIn(kElements), name_of_unread);
INSTANTIATE_TEST_SUITE_P(Rotors, UrdfUnread, ::testing::ValuesIn(kRotors), name_of_unread);
INSTANTIATE_TEST_SUITE_P(Followers, UrdfUnread, ::testing::ValuesIn(kFollowers), name_of_unread);
INSTANTIATE_TEST_SUITE_P(Loops, UrdfUnread, ::testing::ValuesIn(kLoops), name_of_unread);
INSTANTIATE_TEST_SUITE_P(Simulators, UrdfUnread, ::testing::ValuesIn(kOfSimulators), name_of_unread);

class UrdfKinds : public RobotFiles {};

TEST_F(UrdfKinds, AKindIsNotedOnce) {
  read("r.urdf", with("robot", "<one a=\"1\"/><one a=\"2\"/><two/><three/>"));
  EXPECT_EQ(diagnostics_.all().size(), 3U);
  for (const Diagnostic& note : diagnostics_.all()) EXPECT_EQ(note.kind, "unknown elements not read");
}

TEST_F(UrdfKinds, WhatIsAboutSightAndContactIsLeftAside) {
  read("r.urdf",
       with("robot", R"(<material name="m"><color rgba="1 1 1 1"/></material><gazebo reference="arm"><kp>1e5</kp>
      <mu1>1</mu1><selfCollide>true</selfCollide><implicitSpringDamper>1</implicitSpringDamper><sensor><mass>1</mass></sensor>
      <turnGravityOff>false</turnGravityOff></gazebo><ros2_control><joint name="j"><command_interface name="effort"/></joint>
      </ros2_control><mujoco><compiler meshdir="m" balanceinertia="false"/><option gravity="0 0 -9.81"/></mujoco>)"));
  EXPECT_TRUE(diagnostics_.all().empty());
}

// The rotor's inertia of 1e-4 kg m² behind a gear of 10:1, in all words.
TEST_F(UrdfKinds, ReductionsAreReadWhereverTheyStand) {
  const std::string rotor = "<motorInertia>1e-4</motorInertia>";
  for (const std::string& text :
       {"<joint name=\"j\"><mechanicalReduction>10</mechanicalReduction></joint><actuator>" + rotor + "</actuator>",
        "<joint name=\"j\"><mechanical_reduction>10</mechanical_reduction></joint><actuator>" + rotor + "</actuator>",
        "<joint name=\"j\"/><actuator><mechanical_reduction>10</mechanical_reduction>" + rotor + "</actuator>",
        "<joint name=\"j\"/><actuator><reduction>10</reduction>" + rotor + "</actuator>",
        "<joint name=\"j\" mechanicalReduction=\"10\"/><actuator>" + rotor + "</actuator>",
        std::string("<joint name=\"j\"/><actuator motorInertia=\"1e-4\" mechanicalReduction=\"10\"/>"),
        "<joint>j</joint><actuator><mechanicalReduction>10</mechanicalReduction>" + rotor + "</actuator>"}) {
    for (const std::string around : {"", "ros2_control"}) {
      const std::string transmission = "<transmission name=\"t\">" + text + "</transmission>";
      const std::string element =
          around.empty() ? transmission : "<" + around + ">" + transmission + "</" + around + ">";
      EXPECT_EQ(read("r.urdf", with("robot", element)).joints.at(0).armature.number, Number(1) / 100) << element;
      for (const Diagnostic& each : diagnostics_.all()) EXPECT_THAT(each.message, Not(HasSubstr("is not read")));
    }
  }
}

TEST_F(UrdfKinds, APluginMayStandAnywhereInGazebo) {
  const std::string plugin =
      "<plugin name=\"m\"><joint>j</joint><mimicJoint>k</mimicJoint><multiplier>-2</multiplier></plugin>";
  for (const std::string& text : {"<gazebo><model>" + plugin + "</model></gazebo>", plugin}) {
    EXPECT_EQ(joint_positions(read("r.urdf", with("robot", text)))[1].factors, (std::map<int, Number>{{0, -2}}));
  }
}

TEST_F(UrdfKinds, AMimicOfAFixedJointStaysStill) {
  read("r.urdf", with("robot", R"(<link name="h"/><joint name="f" type="fixed"><parent link="hand"/><child link="h"/>
      <mimic joint="j"/></joint>)"));
  ASSERT_EQ(diagnostics_.all().size(), 1U);
  EXPECT_THAT(diagnostics_.all()[0].message, HasSubstr("joint \"f\" is fixed: it stays still"));
}

TEST_F(UrdfKinds, ALoopJointOfDrakeIsALoop) {
  const auto closed_by = [this](const std::string& loop) {
    const auto body = [](const std::string& name) {
      return "<link name=\"" + name +
             "\"><inertial><mass value=\"1\"/><inertia ixx=\"1\" iyy=\"1\" izz=\"1\"/></inertial></link>";
    };
    const auto joint = [](const std::string& name, const std::string& parent, const std::string& child,
                          const std::string& x) {
      return "<joint name=\"" + name + "\" type=\"continuous\"><parent link=\"" + parent + "\"/><child link=\"" +
             child + "\"/><origin xyz=\"" + x + "\"/><axis xyz=\"0 0 1\"/></joint>";
    };
    return read("r.urdf", "<robot name=\"r\"><link name=\"base\"/>" + body("a") + body("b") + body("c") +
                              joint("ja", "base", "a", "0 0 0") + joint("jb", "a", "b", "0 1 0") +
                              joint("jc", "base", "c", "2 0 0") + loop + "</robot>");
  };
  const Robot plus =
      closed_by(R"(<loop name="l" type="continuous"><predecessor link="b"><origin xyz="2 0 0"/></predecessor>
      <successor link="c"><origin xyz="0 1 0"/></successor><axis xyz="0 0 1"/></loop>)");
  const Robot drake = closed_by(R"(<loop_joint name="l" type="continuous"><link1 link="b" xyz="2 0 0"/>
      <link2 link="c" xyz="0 1 0"/><axis xyz="0 0 1"/></loop_joint>)");
  EXPECT_EQ(joints_with_coordinates(drake), joints_with_coordinates(plus));
  EXPECT_EQ(joints_with_coordinates(drake).size(), 1U);
}

}  // namespace
}  // namespace flatdyn
