// SPDX-License-Identifier: GPL-2.0-or-later
// The mechanism is the robot as read, and any changed number of it is found.
#include "truth/definition/as_read.hpp"

#include <gmock/gmock.h>

#include <functional>

#include "proof/verify/proof.hpp"
#include "robot/model/random_robot.hpp"
#include "support/robot_models.hpp"
#include "support/robots.hpp"
#include "support/spatial_loops.hpp"
#include "support/written_model.hpp"

namespace flatdyn {
namespace {

void expect_proven(const Robot& robot, const Mechanism& mechanism) {
  const AsReadResult result = prove_as_read(robot, mechanism);
  EXPECT_TRUE(result.holds) << robot.name << ": " << result.summary();
  EXPECT_TRUE(result.is_exact) << robot.name << ": " << result.summary();
  EXPECT_LT(result.failure_log2, -100) << robot.name << ": " << result.summary();
  EXPECT_GE(result.digits(), 40) << robot.name << ": " << result.summary();
  EXPECT_EQ(result.links, static_cast<int>(robot.links.size()));
}

void expect_proven(const LoadedRobot& model) { expect_proven(model.robot, model.mechanism); }

TEST(AsRead, HoldsForEveryRobotOfTheProject) {
  const std::filesystem::path folder = std::filesystem::path(FLATDYN_SOURCE_DIR) / "robots";
  int robots = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string extension = entry.path().extension();
    if (extension != ".urdf" && extension != ".toml") continue;
    expect_proven(load_robot(entry.path(), {}));
    ++robots;
  }
  EXPECT_GE(robots, 19);
}

// Fixed, revolute and prismatic joints about any axes, with rotors on them.
TEST(AsRead, HoldsForRandomTrees) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Robot robot = testing::random_tree(seed, 6);
    expect_proven(robot, make_mechanism(robot));
  }
  for (const bool chain : {false, true}) {
    const Robot robot = random_robot(chain, 8, 5);
    expect_proven(robot, make_mechanism(robot));
  }
}

// Motors on links before the joint's parent, armatures, limits, bodies on the base, a displaced tip.
Robot arm_with_everything() {
  Robot robot = testing::random_tree(37, 6, true);
  testing::Numbers numbers(3);
  robot.gravity = {numbers.fraction(), numbers.fraction(), -9};
  robot.links[0].inertials = testing::link("", 2, numbers.vector(), testing::real_tensor(numbers)).inertials;
  robot.links[3].inertials.push_back(robot.links[0].inertials[0]);
  robot.links[3].inertials[1].about = Inertial::About::frame_origin;
  robot.links[3].inertials[1].frame.displacements = {testing::translation(numbers.vector()),
                                                     testing::rotation(Displacement::Kind::rotation_y, Number(3) / 10)};
  for (Joint& joint : robot.joints) {
    joint.armature.number = numbers.positive();
    joint.limits.lower = Value{-numbers.positive(), {}};
    joint.limits.effort = Value{numbers.positive(), {}};
    if (joint.type == JointType::fixed) continue;
    if (!joint.motor) joint.motor = testing::motor(numbers);
    joint.motor->axis = numbers.vector();
  }
  robot.joints[4].motor->carrier = 2;
  robot.joints[5].type = JointType::fixed;
  robot.joints[5].motor.reset();
  robot.tip_offset.displacements = {testing::translation(numbers.vector()),
                                    testing::rotation(Displacement::Kind::rotation_z, Number(1) / 3)};
  return robot;
}

TEST(AsRead, HoldsForRotorsOnAnyLinkAndBodiesOnTheBase) {
  const Robot robot = arm_with_everything();
  const Mechanism mechanism = make_mechanism(robot);
  ASSERT_LT(mechanism.body_count() + 1, static_cast<int>(robot.links.size())) << "there is a fixed joint";
  expect_proven(robot, mechanism);
}

TEST(AsRead, HoldsForFreeSymbolsHeldAndCoupledJoints) {
  expect_proven(testing::model_of_toml(R"(name = "symbols"
[[link]]
joint = "a"
mass = "m1"
com = [0.1, "c", 0.03]
inertia = { xx = "I", yy = 0.02, zz = 0.015, xy = 0.001 }
inertia_about = "com"
[[link]]
joint = "b"
xyz = ["l", 0, 0.1]
rpy = ["alpha", 0, 0]
mass = 0.2
com = [0.05, 0, 0.01]
[[link]]
joint = "c"
type = "fixed"
xyz = ["2*l", 0, 0.1]
rpy = [0, 0, "pi/7"]
mass = "m1"
com = [0.05, 0, 0.01]
)"));
  expect_proven(testing::model_of_toml(R"(name = "gripper"
[[link]]
joint = "wrist"
mass = 1
com = [0.1, 0.02, 0.03]
[[link]]
joint = "left"
xyz = [0.2, 0, 0.1]
rpy = [1, 0.2, 0]
axis = [1, 2, 3]
mass = 0.2
com = [0.05, 0, 0.01]
[[link]]
joint = "right"
parent = "link1"
xyz = [0.2, 0, -0.1]
rpy = ["pi/2", 0, 0]
position = "-0.28833*left + 0.1"
mass = 0.3
com = [0.05, 0.01, 0]
[[link]]
joint = "far"
type = "prismatic"
axis = [1, 0, 1]
position = "2*right + 3*wrist - 0.3"
mass = 0.3
com = [0.05, 0.01, 0]
)"));
}

TEST(AsRead, HoldsForHeldJoints) {
  Robot robot = testing::random_tree(6, 6, true);
  robot.joints[2].held = Held{JointType::revolute, Number(7) / 10};
  robot.joints[3].held = Held{JointType::prismatic, Number(1) / 3};
  robot.joints[2].type = robot.joints[3].type = JointType::fixed;
  robot.joints[2].motor.reset();
  robot.joints[3].motor.reset();
  expect_proven(robot, make_mechanism(robot));
}

TEST(AsRead, SaysThatClosureOfLoopsIsNotCompared) {
  for (const std::string& text : {testing::kCutAtHinge, testing::kCutAtBall}) {
    const LoadedRobot model = testing::model_of_toml(text);
    expect_proven(model);
    const AsReadResult result = prove_as_read(model.robot, model.mechanism);
    EXPECT_TRUE(result.has_loops);
    EXPECT_THAT(result.summary(), ::testing::HasSubstr("not compared"));
  }
}

// 0.2 + 0.3 - 0.5 of angles that are replaced one by one: a product of inertia of 1e-58 is snapped to zero.
TEST(AsRead, KnowsResiduesThatAreSnapped) {
  Robot robot = testing::random_tree(2, 3, true);
  const auto about_x = [](const Number& angle) { return testing::rotation(Displacement::Kind::rotation_x, angle); };
  robot.joints[0].type = JointType::revolute;
  robot.joints[1] = testing::joint("hinge", JointType::revolute, 1, 2, {{about_x(1)}, {}}, {0, 0, 1});
  robot.joints[2] = testing::joint("bolt", JointType::fixed, 2, 3, {}, {0, 0, 1});
  robot.joints[2].origin.displacements = {about_x(Number(1) / 5), about_x(Number(3) / 10)};
  robot.links[2].inertials.clear();
  Inertial& inertial = robot.links[3].inertials[0];
  inertial.frame.displacements = {about_x(Number(-1) / 2)};
  inertial.centre_of_mass = zero_vector();
  inertial.tensor = {Vec3{3, 0, 0}, Vec3{0, 3, 0}, Vec3{0, 0, 4}};
  const AsReadResult result = prove_as_read(robot, make_mechanism(robot));
  EXPECT_TRUE(result.holds) << result.summary();
  EXPECT_FALSE(result.is_exact);
}

struct Mutant {
  const char* difference;  // a part of the message
  std::function<void(Mechanism&)> change;
};

Number nudged(const Number& a) { return a + GiNaC::numeric(1) / GiNaC::pow(GiNaC::numeric(10), 30); }

Mat3 turned(const Mat3& R) {
  return R * Mat3{Vec3{Number(3) / 5, Number(-4) / 5, 0}, Vec3{Number(4) / 5, Number(3) / 5, 0}, Vec3{0, 0, 1}};
}

std::vector<Mutant> mutants_of_bodies() {
  return {
      {"mass", [](Mechanism& m) { m.bodies[2].inertia.mass = nudged(m.bodies[2].inertia.mass); }},
      {"first moment",
       [](Mechanism& m) { m.bodies[1].inertia.first_moment[2] = nudged(m.bodies[1].inertia.first_moment[2]); }},
      {"inertia",
       [](Mechanism& m) {
         auto& I = m.bodies[0].inertia.inertia;
         I[0][1] = I[1][0] = nudged(I[0][1]);
       }},
      {"inertia", [](Mechanism& m) { m.bodies[3].inertia.inertia[2][2] = nudged(m.bodies[3].inertia.inertia[2][2]); }},
      {"the base: its mass", [](Mechanism& m) { m.base.mass = nudged(m.base.mass); }},
      {"the base: its first moment", [](Mechanism& m) { m.base.first_moment[0] = nudged(m.base.first_moment[0]); }},
      {"link \"link2\": its inertia",
       [](Mechanism& m) { m.links[2].inertia.inertia[0][0] = nudged(m.links[2].inertia.inertia[0][0]); }},
      {"gravity", [](Mechanism& m) { m.gravity[1] = nudged(m.gravity[1]); }},
  };
}

std::vector<Mutant> mutants_of_places() {
  return {
      {"its place", [](Mechanism& m) { m.bodies[3].p[0] = nudged(m.bodies[3].p[0]); }},
      {"its place", [](Mechanism& m) { m.bodies[1].theta.c = nudged(m.bodies[1].theta.c); }},
      {"its place", [](Mechanism& m) { std::swap(m.bodies[1].theta, m.bodies[1].beta); }},
      {"its place", [](Mechanism& m) { m.bodies[2].alpha.s = -m.bodies[2].alpha.s; }},
      {"its place", [](Mechanism& m) { m.links[3].p[1] = nudged(m.links[3].p[1]); }},
      {"its place", [](Mechanism& m) { m.links[6].R = turned(m.links[6].R); }},
      {"its parent", [](Mechanism& m) { m.bodies[3].parent = 1; }},
      {"its kind", [](Mechanism& m) { m.bodies[2].prismatic = !m.bodies[2].prismatic; }},
      {"the tip: its place", [](Mechanism& m) { m.tip.p[0] = nudged(m.tip.p[0]); }},
      {"the tip: its place", [](Mechanism& m) { m.tip.R = turned(m.tip.R); }},
      {"the tip: its body", [](Mechanism& m) { m.tip.body -= 1; }},
  };
}

std::vector<Mutant> mutants_of_joints() {
  return {
      {"its armature", [](Mechanism& m) { m.bodies[0].armature = nudged(m.bodies[0].armature); }},
      {"its viscous friction", [](Mechanism& m) { m.bodies[1].viscous = nudged(m.bodies[1].viscous); }},
      {"its Coulomb friction", [](Mechanism& m) { m.bodies[1].coulomb = nudged(m.bodies[1].coulomb); }},
      {"its limits", [](Mechanism& m) { m.bodies[2].limits.effort->number += 1; }},
      {"its limits", [](Mechanism& m) { m.bodies[2].limits.lower.reset(); }},
      {"the axis of its rotor", [](Mechanism& m) { m.bodies[3].rotor->axis[0] = nudged(m.bodies[3].rotor->axis[0]); }},
      {"the axis of its rotor", [](Mechanism& m) { m.bodies[3].rotor->axis = Number(-1) * m.bodies[3].rotor->axis; }},
      {"its gear ratio", [](Mechanism& m) { m.bodies[3].rotor->gear_ratio = nudged(m.bodies[3].rotor->gear_ratio); }},
      {"the inertia of its rotor",
       [](Mechanism& m) { m.bodies[3].rotor->inertia = nudged(m.bodies[3].rotor->inertia); }},
      {"the carrier of its rotor", [](Mechanism& m) { m.bodies[3].rotor->carrier -= 1; }},
      {"its rotor", [](Mechanism& m) { m.bodies[3].rotor.reset(); }},
  };
}

void expect_caught(const Robot& robot, const Mechanism& mechanism, const std::vector<Mutant>& mutants) {
  for (std::size_t k = 0; k < mutants.size(); ++k) {
    Mechanism changed = mechanism;
    mutants[k].change(changed);
    const AsReadResult result = prove_as_read(robot, changed);
    EXPECT_FALSE(result.holds) << "mutant " << k << ": " << mutants[k].difference;
    EXPECT_THAT(result.difference, ::testing::HasSubstr(mutants[k].difference)) << "mutant " << k;
    EXPECT_THROW(prove_robot(robot, changed), Failure);
  }
}

TEST(AsRead, CatchesAnyChangedNumber) {
  const Robot robot = arm_with_everything();
  const Mechanism mechanism = make_mechanism(robot);
  expect_caught(robot, mechanism, mutants_of_bodies());
  expect_caught(robot, mechanism, mutants_of_places());
  expect_caught(robot, mechanism, mutants_of_joints());
}

TEST(AsRead, CatchesChangedCouplings) {
  const LoadedRobot model = testing::model_of("planar_2r_absolute.toml");
  expect_caught(model.robot, model.mechanism,
                {{"its coupling", [](Mechanism& m) { m.coupling[1][0] = nudged(m.coupling[1][0]); }},
                 {"its coupling", [](Mechanism& m) { m.offsets[1] = nudged(m.offsets[1]); }},
                 {"have coordinates", [](Mechanism& m) { std::swap(m.coordinates[0], m.coordinates[1]); }}});
}

}  // namespace
}  // namespace flatdyn
