// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/rational_rotation.hpp"

#include <gtest/gtest.h>

#include "support/robots.hpp"

namespace flatdyn {
namespace {

using testing::Numbers;

void expect_orthonormal(const Mat3& R) {
  const Mat3 product = R * transpose(R);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) EXPECT_TRUE(vanishes(product[i][j] - (i == j ? 1 : 0)));
  }
  EXPECT_TRUE(vanishes(dot(cross(R[0], R[1]), R[2]) - 1));
}

void expect_close(const Number& a, const Number& b) {
  const Number bound = exact_decimal("1e-40");
  const Number difference = GiNaC::abs((a - b).evalf());
  EXPECT_TRUE(difference < bound) << a << " and " << b;
}

TEST(PlanarRotation, QuarterTurnsAreExact) {
  for (int k = -5; k <= 5; ++k) {
    const PlanarRotation r = planar_rotation(k * GiNaC::Pi / 2);
    EXPECT_TRUE(r.c.is_equal(GiNaC::cos(k * GiNaC::Pi / 2)));
    EXPECT_TRUE(r.s.is_equal(GiNaC::sin(k * GiNaC::Pi / 2)));
  }
}

TEST(PlanarRotation, OtherAnglesAreRationalOnTheCircleAndClose) {
  GiNaC::Digits = 60;
  Numbers numbers(7);
  for (int k = 0; k < 50; ++k) {
    const Number angle = 10 * numbers.fraction();
    const PlanarRotation r = planar_rotation(angle);
    EXPECT_TRUE(is_rational(r.c) && is_rational(r.s));
    EXPECT_TRUE(vanishes(r.c * r.c + r.s * r.s - 1));
    expect_close(r.c, GiNaC::cos(angle));
    expect_close(r.s, GiNaC::sin(angle));
  }
}

TEST(RotationOnto, TakesZToTheAxis) {
  GiNaC::Digits = 60;
  Numbers numbers(11);
  for (int k = 0; k < 30; ++k) {
    const Vec3 axis = k < 6 ? Vec3{k / 2 == 0 ? 1 - 2 * (k % 2) : 0, k / 2 == 1 ? 1 - 2 * (k % 2) : 0,
                                   k / 2 == 2 ? 1 - 2 * (k % 2) : 0}
                            : numbers.vector();
    const Mat3 R = rotation_onto(axis);
    expect_orthonormal(R);
    const Number length = GiNaC::sqrt(dot(axis, axis));
    for (std::size_t i = 0; i < 3; ++i) expect_close(R[i][2], axis[i] / length);
  }
}

TEST(ZxzAngles, GiveTheRotationBack) {
  GiNaC::Digits = 60;
  Numbers numbers(13);
  for (int k = 0; k < 40; ++k) {
    const auto angle = [&]() -> Number {
      return numbers.integer(0, 1) == 0 ? Number(GiNaC::Pi * numbers.integer(-2, 2) / 2) : numbers.fraction();
    };
    const Mat3 R = rotation_z(planar_rotation(angle())) * rotation_y(planar_rotation(angle())) *
                   rotation_x(planar_rotation(angle()));
    const ZxzAngles a = zxz_angles(expanded(R));
    const Mat3 again = rotation_z(a.beta) * rotation_x(a.alpha) * rotation_z(a.theta);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) expect_close(again[i][j].expand(), R[i][j].expand());
    }
  }
}

TEST(ZxzAngles, ParallelAxesNeedOneAngle) {
  const ZxzAngles a = zxz_angles(rotation_z(planar_rotation(exact_decimal("0.3"))));
  EXPECT_TRUE(a.beta.is_identity());
  EXPECT_TRUE(a.alpha.is_identity());
  EXPECT_FALSE(a.theta.is_identity());
}

}  // namespace
}  // namespace flatdyn
