// SPDX-License-Identifier: GPL-2.0-or-later
// The number of base parameters and their choice, and that link-by-link regrouping and sampling agree on every entry of
// K.
#include "derivation/parameters/base_parameters.hpp"

#include <gtest/gtest.h>

#include "robot/model/field_mechanism.hpp"
#include "support/robot_models.hpp"
#include "support/robots.hpp"
#include "truth/definition/sampled_base.hpp"

namespace flatdyn {
namespace {

struct Counts {
  int inertial, with_rotors, full;
};

int count_with_rotors(Mechanism mechanism) {
  for (Body& body : mechanism.bodies) {
    body.viscous = body.coulomb = 0;
    if (!body.rotor) body.armature = 1;
  }
  return base_parameters(mechanism, ParameterSet::given).size();
}

void expect_counts(const Mechanism& mechanism, const Counts& expected) {
  EXPECT_EQ(base_parameters(mechanism, ParameterSet::inertial).size(), expected.inertial) << mechanism.name;
  EXPECT_EQ(count_with_rotors(mechanism), expected.with_rotors) << mechanism.name;
  EXPECT_EQ(base_parameters(mechanism, ParameterSet::full).size(), expected.full) << mechanism.name;
}

void expect_agreement(const Mechanism& mechanism) {
  for (const ParameterSet set :
       {ParameterSet::inertial, ParameterSet::given, ParameterSet::full, ParameterSet::nonzero}) {
    const BaseParameters base = base_parameters(mechanism, set);
    const SampledComparison sampled = compare_with_samples(mechanism, base, set);
    EXPECT_TRUE(sampled.equal) << mechanism.name << " set " << static_cast<int>(set) << ": " << base.size()
                               << " base parameters, sampled rank " << sampled.rank;
  }
}

// A chain with modified DH constants and general inertias; gravity is along the first axis.
Robot dh_chain(const std::string& name, const std::vector<std::array<Number, 3>>& a_alpha_d,
               const std::string& prismatic = "") {
  testing::Numbers numbers(5);
  Robot robot;
  robot.name = name;
  robot.links.push_back({"base", {}, {}});
  robot.root = 0;
  robot.gravity = {0, 0, GiNaC::numeric(-981, 100)};
  for (std::size_t i = 0; i < a_alpha_d.size(); ++i) {
    const std::string n = std::to_string(i + 1);
    const auto& [a, alpha, d] = a_alpha_d[i];
    robot.links.push_back(
        testing::link("link" + n, numbers.positive(), numbers.vector(), testing::real_tensor(numbers)));
    const Pose origin{{testing::translation({a, 0, 0}), testing::rotation(Displacement::Kind::rotation_x, alpha),
                       testing::translation({0, 0, d})},
                      {}};
    const JointType type = prismatic == n ? JointType::prismatic : JointType::revolute;
    const int parent = static_cast<int>(i);
    robot.joints.push_back(testing::joint("joint" + n, type, parent, parent + 1, origin, {0, 0, 1}));
  }
  robot.tip = static_cast<int>(a_alpha_d.size());
  return robot;
}

const Number kQuarter = GiNaC::Pi / 2;
Number centi(int value) { return GiNaC::numeric(value, 100); }

Robot stanford() {
  return dh_chain(
      "stanford",
      {{0, 0, 0}, {0, -kQuarter, centi(15)}, {0, kQuarter, 0}, {0, 0, 0}, {0, -kQuarter, 0}, {0, kQuarter, 0}}, "3");
}

Robot seven_axes(const std::string& name, const Number& elbow) {
  return dh_chain(name, {{0, 0, 0},
                         {0, -kQuarter, 0},
                         {0, kQuarter, centi(40)},
                         {elbow, kQuarter, 0},
                         {-elbow, -kQuarter, centi(39)},
                         {0, kQuarter, 0},
                         {0, -kQuarter, 0}});
}

Mechanism planar(bool vertical) {
  Mechanism mechanism = make_mechanism(dh_chain("planar", {{0, 0, 0}, {centi(50), 0, 0}}));
  if (vertical) mechanism.gravity = {0, centi(-981), 0};
  return mechanism;
}

TEST(BaseParameters, AreAsManyAsIsKnown) {
  for (const char* file : {"puma560.toml", "rx90.toml", "ur5.urdf"}) {
    expect_counts(testing::model_of(file).mechanism, {36, 40, 52});
  }
  expect_counts(testing::model_of("panda.urdf").mechanism, {43, 48, 62});
  expect_counts(testing::model_of("scara.toml").mechanism, {8, 11, 19});
  expect_counts(make_mechanism(stanford()), {33, 37, 49});
  expect_counts(make_mechanism(seven_axes("iiwa", 0)), {43, 48, 62});
  expect_counts(make_mechanism(seven_axes("wam", GiNaC::numeric(45, 1000))), {43, 48, 62});
  expect_counts(planar(true), {6, 7, 11});
  expect_counts(planar(false), {4, 5, 9});
}

// Two perpendicular prismatic joints: m_1 + m_2 and m_2, or with rotors two that the motors feel; friction adds two
// each.
TEST(BaseParameters, OfACartesianArm) { expect_counts(testing::model_of("cartesian_2.toml").mechanism, {2, 3, 7}); }

// Angles, and lengths of axes, are replaced by rational numbers one by one; sums of them that must cancel still vanish.
TEST(BaseParameters, AreAsFewWhereAnglesCancel) {
  Robot robot = dh_chain("turned there and back", {{0, 0, 0}, {centi(50), 0, 0}});
  for (const int angle : {30, 20, -50}) {
    robot.joints[1].origin.displacements.push_back(testing::rotation(Displacement::Kind::rotation_x, centi(angle)));
  }
  const Mechanism mechanism = make_mechanism(robot);
  EXPECT_TRUE(mechanism.bodies[1].alpha.s.is_zero());
  expect_counts(mechanism, {4, 5, 9});
}

TEST(BaseParameters, AreAsFewForASlideAtARightAngleOfAnyDirection) {
  Robot robot = dh_chain("slide", {{0, 0, 0}, {0, 0, 0}, {centi(30), 0, 0}}, "2");
  robot.joints[1].axis = {1, 0, 0};
  const int along_x = base_parameters(make_mechanism(robot)).size();
  for (const Vec3& axis : {Vec3{1, 1, 0}, Vec3{1, 2, 0}, Vec3{3, -1, 0}, Vec3{centi(30), centi(70), 0}}) {
    robot.joints[1].axis = axis;
    const Mechanism mechanism = make_mechanism(robot);
    EXPECT_TRUE(mechanism.bodies[1].alpha.c.is_zero());
    EXPECT_TRUE(mechanism.bodies[2].alpha.c.is_zero());
    EXPECT_EQ(base_parameters(mechanism).size(), along_x);
  }
}

// The second axis intersects the first, which is along (1, 2, 2); the first common normal has no length.
TEST(BaseParameters, AreAsFewWhereAxesMeetAtAnyAngle) {
  Robot robot = dh_chain("meeting", {{0, 0, 0}, {0, 0, 0}});
  robot.gravity = zero_vector();
  robot.joints[0].axis = {1, 2, 2};
  robot.joints[1].origin = Pose{{testing::translation({centi(20), centi(40), centi(40)})}, {}};
  const Mechanism mechanism = make_mechanism(robot);
  for (const Number& p : mechanism.bodies[1].p) EXPECT_TRUE(p.is_zero() || nearest_double(p) > 0.1);
  EXPECT_TRUE(mechanism.bodies[1].p[0].is_zero());
  Robot at_the_origin = robot;
  at_the_origin.joints[1].origin = {};
  EXPECT_EQ(base_parameters(mechanism).size(), base_parameters(make_mechanism(at_the_origin)).size());
}

TEST(BaseParameters, OfEveryRobotAgreeWithSamples) {
  for (const char* file :
       {"cartesian_2.toml", "panda.urdf", "pendulum_motor.toml", "planar_2r.toml", "prismatic_revolute.toml",
        "puma560.toml", "quadruped12.urdf", "rx90.toml", "scara.toml", "ur5.urdf"}) {
    expect_agreement(testing::model_of(file).mechanism);
  }
}

TEST(BaseParameters, OfADozenJointsOnFourLegs) {
  const Mechanism mechanism = testing::model_of("quadruped12.urdf").mechanism;
  EXPECT_EQ(base_parameters(mechanism, ParameterSet::inertial).size(), 68);
}

// On a wall or a slope the first joint feels gravity: two more first moments count.
TEST(BaseParameters, DependOnHowTheBaseIsMounted) {
  for (const char* file : {"ur5.urdf", "panda.urdf", "quadruped12.urdf", "rx90.toml"}) {
    Mechanism mechanism = testing::model_of(file).mechanism;
    const int upright = base_parameters(mechanism, ParameterSet::inertial).size();
    mechanism.gravity = {centi(981), 0, 0};  // on a wall
    expect_agreement(mechanism);
    const int on_wall = base_parameters(mechanism, ParameterSet::inertial).size();
    mechanism.gravity = {centi(300), centi(400), centi(-1200)};  // on a slope
    expect_agreement(mechanism);
    const int tilted = base_parameters(mechanism, ParameterSet::inertial).size();
    mechanism.gravity = zero_vector();  // in orbit
    expect_agreement(mechanism);
    const int in_orbit = base_parameters(mechanism, ParameterSet::inertial).size();
    // The four first axes are along x: gravity crosses them unless it is along x, too.
    if (mechanism.name == "quadruped12") {
      EXPECT_EQ(tilted, upright);
      EXPECT_EQ(on_wall, upright - 8);
      continue;
    }
    EXPECT_EQ(on_wall, upright + 2) << file;
    EXPECT_EQ(tilted, upright + 2) << file;
    EXPECT_LT(in_orbit, on_wall) << file;
  }
}

TEST(BaseParameters, WithoutGravityAPrismaticArmKeepsItsMasses) {
  Mechanism mechanism = testing::model_of("cartesian_2.toml").mechanism;
  mechanism.gravity = zero_vector();
  expect_agreement(mechanism);
}

// All π with the same K π give the same torques: with_base_parameters() is the same robot as far as torques tell.
TEST(BaseParameters, AreAllThatTorquesDependOn) {
  for (const unsigned seed : {2U, 3U, 8U}) {
    const Mechanism mechanism = make_mechanism(testing::random_tree(seed, 5));
    const BaseParameters base = base_parameters(mechanism);
    const Mechanism reduced = with_base_parameters(mechanism, base, base_values(mechanism, base));
    const std::vector<Number> pi = dynamic_parameters(reduced), pi_b = base_values(reduced, base);
    std::size_t nonzero = 0;
    for (const Number& value : pi) nonzero += vanishes(value) ? 0 : 1;
    EXPECT_LE(nonzero, base.columns.size());
    for (std::size_t k = 0; k < pi_b.size(); ++k) {
      EXPECT_TRUE(vanishes(pi_b[k] - base_values(mechanism, base)[k])) << parameter_name(base.columns[k]);
    }
  }
}

// The comparison notices a wrong entry of K, a missing parameter and one too many.
TEST(SampledBase, NoticesEveryMistake) {
  const Mechanism mechanism = testing::model_of("ur5.urdf").mechanism;
  const BaseParameters base = base_parameters(mechanism, ParameterSet::inertial);
  const auto agrees = [&](const BaseParameters& changed) {
    return compare_with_samples(mechanism, changed, ParameterSet::inertial).equal;
  };
  ASSERT_TRUE(agrees(base));
  for (std::size_t k = 0; k < base.columns.size(); k += 7) {
    BaseParameters wrong = base;
    wrong.combination[k].rbegin()->second += GiNaC::numeric(1, 1000000);
    EXPECT_FALSE(agrees(wrong)) << k;
    wrong = base;
    wrong.columns.erase(wrong.columns.begin() + static_cast<std::ptrdiff_t>(k));
    wrong.combination.erase(wrong.combination.begin() + static_cast<std::ptrdiff_t>(k));
    EXPECT_FALSE(agrees(wrong)) << k;
  }
  BaseParameters longer = base;
  longer.columns.push_back(0);
  longer.combination.push_back({{0, 1}});
  EXPECT_FALSE(agrees(longer));
}

}  // namespace
}  // namespace flatdyn
