// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/mechanism.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "robot/model/rational_rotation.hpp"
#include "support/robots.hpp"

namespace flatdyn {
namespace {

using namespace flatdyn::testing;
using Kind = Displacement::Kind;

struct Placed {
  Mat3 R = identity_matrix();
  Vec3 p = zero_vector();
};

Placed then(const Placed& a, const Placed& b) { return {expanded(a.R * b.R), expanded(a.p + a.R * b.p)}; }

Placed placed(const Pose& pose) {
  Placed result;
  for (const Displacement& d : pose.displacements) {
    const PlanarRotation turn = planar_rotation(d.angle);
    const Mat3 R = d.kind == Kind::rotation_x   ? rotation_x(turn)
                   : d.kind == Kind::rotation_y ? rotation_y(turn)
                   : d.kind == Kind::rotation_z ? rotation_z(turn)
                                                : identity_matrix();
    result = then(result, {R, d.translation});
  }
  return result;
}

// The displacement by which a joint moves its child, by Rodrigues' formula: c 1 + s S(u) + (1 - c) u uᵀ.
Placed motion(const Joint& joint, const Number& q) {
  const Vec3 u = unit(joint.axis);
  if (joint.type == JointType::prismatic) return {identity_matrix(), q * u};
  if (joint.type == JointType::fixed) return {};
  const PlanarRotation turn = planar_rotation(q);
  const Mat3 S = skew(u), S2 = S * S;
  Mat3 R = identity_matrix();
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) R[i][j] += turn.s * S[i][j] + (1 - turn.c) * S2[i][j];
  }
  return {R, zero_vector()};
}

// The links of the robot as written, placed for joint positions q[joint].
std::vector<Placed> written_links(const Robot& robot, const std::vector<Number>& q) {
  std::vector<Placed> links(robot.links.size());
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {  // parents come first in random_tree
    const Joint& joint = robot.joints[j];
    const Placed frame = then(links[static_cast<std::size_t>(joint.parent)], placed(joint.origin));
    links[static_cast<std::size_t>(joint.child)] = then(then(frame, motion(joint, q[j])), placed(joint.link_offset));
  }
  return links;
}

std::vector<Placed> mechanism_bodies(const Mechanism& mechanism, const std::vector<Number>& q) {
  std::vector<Placed> bodies;
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    const Body& body = mechanism.bodies[i];
    const Placed parent = body.parent < 0 ? Placed{} : bodies[static_cast<std::size_t>(body.parent)];
    const Placed moved = body.prismatic ? Placed{identity_matrix(), {0, 0, q[i]}}
                                        : Placed{rotation_z(planar_rotation(q[i])), zero_vector()};
    bodies.push_back(then(then(parent, {constant_rotation(body), body.p}), moved));
  }
  return bodies;
}

class RandomTree : public ::testing::TestWithParam<unsigned> {};

// Every written link must be where the file puts it, whatever the canonical frames are.
TEST_P(RandomTree, LinksStayWhereTheyAreWritten) {
  GiNaC::Digits = 60;
  const Robot robot = random_tree(GetParam(), 5);
  const Mechanism mechanism = make_mechanism(robot);
  Numbers numbers(GetParam() + 1000);
  std::vector<Number> q(robot.joints.size(), 0), q_moving;
  for (const Body& body : mechanism.bodies) {
    const auto named = [&](const Joint& joint) { return joint.name == body.joint; };
    const auto j = std::find_if(robot.joints.begin(), robot.joints.end(), named) - robot.joints.begin();
    q[static_cast<std::size_t>(j)] = numbers.fraction();
    q_moving.push_back(q[static_cast<std::size_t>(j)]);
  }
  const std::vector<Placed> written = written_links(robot, q), bodies = mechanism_bodies(mechanism, q_moving);
  const Number bound = exact_decimal("1e-38");
  for (std::size_t l = 0; l < written.size(); ++l) {
    const LinkFrame& frame = mechanism.links[l];
    const Placed body = frame.body < 0 ? Placed{} : bodies[static_cast<std::size_t>(frame.body)];
    const Placed here = then(body, {frame.R, frame.p});
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_TRUE(GiNaC::abs((here.p[i] - written[l].p[i]).evalf()) < bound) << robot.links[l].name;
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_TRUE(GiNaC::abs((here.R[i][k] - written[l].R[i][k]).evalf()) < bound) << robot.links[l].name;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomTree, ::testing::Range(1u, 13u));

// The common normal of axes that are 1e-6 rad from parallel is a million times as far away as the axes' distance.
TEST(NearlyParallelAxes, HaveFramesThatAreNear) {
  Robot robot = random_tree(1, 5);
  for (Joint& joint : robot.joints) {
    joint.axis = {0, 0, 1};
    for (Displacement& each : joint.origin.displacements) each.angle = each.angle / 1000000;
  }
  for (const Body& body : make_mechanism(robot).bodies) {
    for (const Number& entry : body.p) EXPECT_LT(std::abs(nearest_double(entry)), 30) << body.joint;
  }
}

Robot planar_chain() {
  Robot robot;
  robot.name = "planar";
  robot.links = {{"base", {}, {}},
                 link("a", 1, {1, 0, 0}, identity_matrix()),
                 link("b", 2, {1, 0, 0}, identity_matrix()),
                 link("tool", 3, {0, 0, 0}, zero_matrix())};
  robot.root = 0;
  robot.tip = 3;
  const Pose ahead{{translation({1, 0, GiNaC::numeric(1, 2)})}, {}};
  robot.joints = {joint("j1", JointType::revolute, 0, 1, {}, {0, 0, 1}),
                  joint("j2", JointType::revolute, 1, 2, ahead, {0, 0, 1}),
                  joint("mount", JointType::fixed, 2, 3, ahead, {1, 0, 0})};
  return robot;
}

TEST(MakeMechanism, MergesWhatFixedJointsJoin) {
  const Mechanism mechanism = make_mechanism(planar_chain());
  ASSERT_EQ(mechanism.size(), 2);
  EXPECT_EQ(mechanism.merged, std::vector<std::string>{"tool"});
  EXPECT_TRUE(mechanism.bodies[1].inertia.mass.is_equal(5));
  EXPECT_TRUE(vanishes(mechanism.bodies[1].inertia.first_moment[0] - 5));  // 2·1 + 3·1
}

TEST(MakeMechanism, MovesTheOriginAlongParallelAxesSoThatOffsetsVanish) {
  const Mechanism mechanism = make_mechanism(planar_chain());
  EXPECT_TRUE(mechanism.bodies[1].p[0].is_equal(1));
  EXPECT_TRUE(vanishes(mechanism.bodies[1].p[1]));
  EXPECT_TRUE(vanishes(mechanism.bodies[1].p[2]));
}

TEST(MakeMechanism, PutsAStillRotorOnItsCarrier) {
  Robot robot = planar_chain();
  Numbers numbers(3);
  robot.joints[1].motor = motor(numbers);
  const Mechanism mechanism = make_mechanism(robot);
  EXPECT_TRUE(vanishes(mechanism.bodies[0].inertia.mass - 1 - robot.joints[1].motor->mass.number));
  ASSERT_TRUE(mechanism.bodies[1].rotor.has_value());
  EXPECT_EQ(mechanism.bodies[1].rotor->carrier, 0);
}

TEST(MakeMechanism, RefusesAMotorThatIsNotBetweenBaseAndJoint) {
  Robot robot = planar_chain();
  Numbers numbers(3);
  robot.joints[0].motor = motor(numbers);
  robot.joints[0].motor->carrier = 2;
  EXPECT_THROW(make_mechanism(robot), Failure);
}

TEST(InertialParameters, TransformAndBack) {
  Numbers numbers(5);
  const Vec3 p = numbers.vector();
  const Mat3 R = rotation_x(planar_rotation(numbers.fraction())) * rotation_z(planar_rotation(numbers.fraction()));
  const InertialParameters body{numbers.positive(), numbers.vector(), real_tensor(numbers)};
  const InertialParameters moved = transformed(body, R, p);
  const InertialParameters back = transformed(moved, transpose(R), expanded(Number(-1) * (transpose(R) * p)));
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(vanishes(back.first_moment[i] - body.first_moment[i]));
    for (std::size_t j = 0; j < 3; ++j) EXPECT_TRUE(vanishes(back.inertia[i][j] - body.inertia[i][j]));
  }
}

// Numbers and symbols are transformed by different code.
TEST(InertialParameters, NumbersAreTransformedAsSymbolsAre) {
  Numbers numbers(6);
  const Vec3 p = numbers.vector();
  const Mat3 R = rotation_x(planar_rotation(numbers.fraction())) * rotation_z(planar_rotation(numbers.fraction()));
  const InertialParameters body{numbers.positive(), numbers.vector(), real_tensor(numbers)};
  const InertialParameters moved = transformed(body, R, p);
  const GiNaC::symbol zero("zero");
  InertialParameters with_symbol = body;
  with_symbol.mass += zero;
  const InertialParameters expected = transformed(with_symbol, R, p);
  EXPECT_TRUE(moved.mass.is_equal(body.mass));
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(moved.first_moment[i].is_equal(expected.first_moment[i].subs(zero == 0)));
    for (std::size_t j = 0; j < 3; ++j) {
      EXPECT_TRUE(moved.inertia[i][j].is_equal(expected.inertia[i][j].subs(zero == 0)));
    }
  }
}

}  // namespace
}  // namespace flatdyn
