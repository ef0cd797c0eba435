// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/physical_inertia.hpp"

#include <gtest/gtest.h>

namespace flatdyn {
namespace {

Mat3 diagonal(const Number& x, const Number& y, const Number& z) {
  return {Vec3{x, 0, 0}, Vec3{0, y, 0}, Vec3{0, 0, z}};
}

TEST(PhysicalInertia, DecidesTheBoundaryExactly) {
  EXPECT_FALSE(fault_of_inertia(diagonal(exact_decimal("0.1"), exact_decimal("0.2"), exact_decimal("0.3"))));
  EXPECT_EQ(
      fault_of_inertia(diagonal(exact_decimal("0.1"), exact_decimal("0.2"), exact_decimal("0.3000000000000000001"))),
      InertiaFault::triangle_inequality);
  EXPECT_FALSE(fault_of_inertia(diagonal(0, 0, 0)));
  EXPECT_EQ(fault_of_inertia(diagonal(1, 1, -1)), InertiaFault::not_positive_semidefinite);
}

TEST(PhysicalInertia, SeesThroughARotation) {
  // diag(1, 2, 3.5) turned about z by the angle with cosine 3/5
  const Mat3 R = {Vec3{Number(3) / 5, Number(-4) / 5, 0}, Vec3{Number(4) / 5, Number(3) / 5, 0}, Vec3{0, 0, 1}};
  const Mat3 bad = R * diagonal(1, 2, Number(7) / 2) * transpose(R);
  EXPECT_EQ(fault_of_inertia(bad), InertiaFault::triangle_inequality);
  EXPECT_FALSE(fault_of_inertia(R * diagonal(1, 2, 3) * transpose(R)));
  EXPECT_NEAR(principal_moments(bad)[0], 3.5, 1e-12);
  EXPECT_NEAR(principal_moments(bad)[2], 1.0, 1e-12);
}

TEST(PhysicalInertia, SaysNothingOfSymbols) { EXPECT_FALSE(fault_of_inertia(diagonal(GiNaC::symbol("I"), 1, -1))); }

TEST(PhysicalInertia, MovesTheTensorToTheCentreOfMass) {
  Inertial inertial;
  inertial.mass.number = 2;
  inertial.centre_of_mass = {1, 0, 0};
  inertial.tensor = diagonal(1, 3, 3);
  inertial.about = Inertial::About::frame_origin;
  const Mat3 central = central_tensor(inertial);
  EXPECT_TRUE(central[0][0].is_equal(1));
  EXPECT_TRUE(central[1][1].is_equal(1));
}

}  // namespace
}  // namespace flatdyn
