// SPDX-License-Identifier: GPL-2.0-or-later
// The data of a robot file must reach the reference: frames of inertias, their reference points, unnormalised axes, the
// order of joints, motors, symbols.
#include "truth/reference/reference_model.hpp"

#include <gtest/gtest.h>

#include "support/robots.hpp"

namespace flatdyn {
namespace {

using testing::joint;
using testing::rotation;
using testing::translation;
using Kind = Displacement::Kind;

const Real50 kTolerance("1e-50");

template <class Matrix>
void expect_near(const Matrix& a, const Matrix& b) {
  EXPECT_LE(Matrix(a - b).cwiseAbs().maxCoeff(), kTolerance) << a << "\nnot\n" << b;
}

Real50 decimal(const char* text) { return Real50(text); }

Robot one_joint(const Inertial& inertial, const Vec3& axis = {0, 0, 1}) {
  Robot robot;
  robot.links = {{"base", {}, {}}, {"body", {inertial}, {}}};
  robot.joints = {joint("turn", JointType::revolute, 0, 1, {}, axis)};
  robot.root = 0;
  robot.tip = 1;
  return robot;
}

Inertial box() {
  Inertial inertial;
  inertial.mass.number = 2;
  inertial.frame.displacements = {translation({1, 2, 3}), rotation(Kind::rotation_z, GiNaC::Pi / 2)};
  inertial.centre_of_mass = {GiNaC::numeric(1, 10), 0, 0};
  inertial.tensor = {Vec3{1, GiNaC::numeric(1, 5), 0}, Vec3{GiNaC::numeric(1, 5), 2, 0}, Vec3{0, 0, 3}};
  return inertial;
}

// A quarter turn about z: x of the inertial frame is y of the link.
TEST(ReferenceModel, TurnsInertiasIntoTheLinksAxes) {
  const auto robot = reference_robot<Real50>(one_joint(box()), {});
  const auto& body = robot.links[1].inertials.at(0);
  expect_near(body.r_C, reference::Vector3<Real50>(1, decimal("2.1"), 3));
  reference::Matrix3<Real50> expected;
  expected << 2, decimal("-0.2"), 0, decimal("-0.2"), 1, 0, 0, 0, 3;
  expect_near(body.inertia, expected);
}

TEST(ReferenceModel, MovesInertiasToTheCentreOfMass) {
  Inertial about_origin = box();
  about_origin.about = Inertial::About::frame_origin;
  const auto robot = reference_robot<Real50>(one_joint(about_origin), {});
  reference::Matrix3<Real50> expected;  // minus m r² about y and z of the inertial frame
  expected << decimal("1.98"), decimal("-0.2"), 0, decimal("-0.2"), 1, 0, 0, 0, decimal("2.98");
  expect_near(robot.links[1].inertials.at(0).inertia, expected);
}

TEST(ReferenceModel, NormalisesAxes) {
  const auto robot = reference_robot<Real50>(one_joint(box(), {3, 0, 4}), {});
  expect_near(robot.joints.at(0).axis, reference::Vector3<Real50>(decimal("0.6"), 0, decimal("0.8")));
}

// URDF's roll, pitch, yaw: R = Rz(yaw) Ry(pitch) Rx(roll), with exact angles to 50 digits.
TEST(ReferenceModel, MultipliesDisplacementsFromTheLeft) {
  Robot robot = one_joint(box());
  robot.joints[0].origin.displacements = {translation({1, 0, 0}), rotation(Kind::rotation_z, GiNaC::Pi / 2),
                                          rotation(Kind::rotation_y, 0), rotation(Kind::rotation_x, GiNaC::Pi / 6)};
  const auto converted = reference_robot<Real50>(robot, {});
  const Real50 c = sqrt(Real50(3)) / 2, s = decimal("0.5");
  reference::Matrix3<Real50> expected;
  expected << 0, -c, s, 1, 0, 0, 0, s, c;
  expect_near(converted.joints.at(0).R_0, expected);
  expect_near(converted.joints.at(0).p_0, reference::Vector3<Real50>(1, 0, 0));
}

TEST(ReferenceModel, NumbersJointsDepthFirst) {
  Robot robot;
  for (const char* name : {"base", "a", "b", "a1", "b1"}) robot.links.push_back({name, {}, {}});
  robot.root = 0;
  robot.tip = 4;
  robot.joints = {joint("to_a", JointType::revolute, 0, 1, {}, {0, 0, 1}),
                  joint("to_b", JointType::fixed, 0, 2, {}, {0, 0, 1}),
                  joint("to_b1", JointType::prismatic, 2, 4, {}, {0, 0, 1}),
                  joint("to_a1", JointType::continuous, 1, 3, {}, {0, 0, 1})};
  const auto converted = reference_robot<double>(robot, {});
  std::vector<int> index_of_link(5, -1);
  for (const auto& each : converted.joints) index_of_link[static_cast<std::size_t>(each.child)] = each.index;
  EXPECT_EQ(index_of_link, (std::vector<int>{-1, 0, -1, 1, 2}));
  EXPECT_EQ(converted.size(), 3);
}

TEST(ReferenceModel, PutsRotorsOnTheirCarriers) {
  Robot robot = one_joint(box());
  Motor motor;
  motor.mass.number = 5;
  motor.inertia_axial.number = GiNaC::numeric(1, 2);
  motor.inertia_transverse.number = GiNaC::numeric(1, 4);
  motor.gear_ratio.number = -7;
  motor.axis = {0, 2, 0};
  motor.position = {0, 0, 1};
  robot.joints[0].motor = motor;
  const auto converted = reference_robot<Real50>(robot, {});
  const auto& rotor = converted.joints.at(0).rotor;
  EXPECT_EQ(rotor.carrier, 0);
  EXPECT_EQ(rotor.gear_ratio, -7);
  EXPECT_EQ(rotor.inertia, decimal("0.5"));
  const auto& still = converted.links[0].inertials.at(0);
  EXPECT_EQ(still.mass, 5);
  expect_near(still.r_C, reference::Vector3<Real50>(0, 0, 1));
  expect_near(still.inertia,
              reference::Matrix3<Real50>(
                  reference::Vector3<Real50>(decimal("0.25"), decimal("0.5"), decimal("0.25")).asDiagonal()));
}

TEST(ReferenceModel, PutsInTheSymbolsValues) {
  const GiNaC::symbol m("m");
  Inertial inertial = box();
  inertial.mass.number = 3 * m;
  Robot robot = one_joint(inertial);
  robot.symbols = {{m, "m", {}}};
  EXPECT_EQ(reference_robot<Real50>(robot, {GiNaC::numeric(5, 4)}).links[1].inertials.at(0).mass, decimal("3.75"));
  const SymbolValues drawn = random_symbol_values(robot, 1);
  ASSERT_EQ(drawn.size(), 1u);
  EXPECT_GT(to_scalar<double>(drawn[0], {}), 0);
  EXPECT_EQ(Real50(to_scalar<double>(drawn[0], {})), to_scalar<Real50>(drawn[0], {})) << "doubles must hold them";
}

TEST(ReferenceModel, KeepsThePositionsOfCoupledJoints) {
  reference::Robot<double> robot;
  robot.joints.resize(2);
  for (int k = 0; k < 2; ++k) robot.joints[static_cast<std::size_t>(k)].index = k;
  robot.coupling = reference::VectorX<double>{{1, -2}};
  reference::VectorX<double> q{{0.3}};
  reference::take_orientations(robot, q);
  EXPECT_EQ(q, (reference::VectorX<double>{{0.3}}));
}

// A decimal is rounded to the nearest double.
TEST(ReferenceModel, RoundsOnce) { EXPECT_EQ(to_scalar<double>(exact_decimal("0.1"), {}), 0.1); }

}  // namespace
}  // namespace flatdyn
