// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/exact_sign.hpp"

#include <gtest/gtest.h>

#include "base/diagnostics/diagnostics.hpp"
#include "robot/model/physical_inertia.hpp"
#include "robot/model/rational_rotation.hpp"

namespace flatdyn {
namespace {

Number root(const Number& a) { return GiNaC::sqrt(a); }

const Number kPi = GiNaC::Pi;

TEST(ExactSign, IsThatOfRationals) {
  EXPECT_EQ(sign_of(exact_decimal("-1e-400")), -1);
  EXPECT_EQ(sign_of(0), 0);
  EXPECT_EQ(sign_of(exact_decimal("1e300")), 1);
}

TEST(ExactSign, IsThatOfPiAndRoots) {
  EXPECT_EQ(sign_of(-root(2)), -1);
  EXPECT_EQ(sign_of(-kPi / 2), -1);
  EXPECT_EQ(sign_of(2 - root(2)), 1);
  EXPECT_EQ(sign_of(root(2) + root(3) - kPi), 1);  // 3.146 > 3.142
  EXPECT_EQ(sign_of(GiNaC::pow(kPi, -3) - exact_decimal("0.0323")), -1);
}

TEST(ExactSign, IsFoundWhereDoublesSeeZero) {
  // pi lies between two fractions of 250 digits; a convergent's error is smaller than a double's last place.
  const Number below = exact_decimal(to_decimal(kPi, 250)) - exact_decimal("1e-249");
  EXPECT_EQ(sign_of(kPi - below), 1);
  EXPECT_EQ(sign_of(below - kPi), -1);
  EXPECT_EQ(sign_of(GiNaC::pow(root(2) - 1, 500)), 1);  // 1e-191
}

TEST(ExactSign, IsZeroWhereRootsCancel) {
  EXPECT_EQ(sign_of(root(2) * root(2) - 2), 0);
  EXPECT_EQ(sign_of(root(8) - 2 * root(2)), 0);
  EXPECT_EQ(sign_of(root(5 + 2 * root(6)) - root(2) - root(3)), 0);
  EXPECT_EQ(sign_of(1 / (1 + root(2)) - root(2) + 1), 0);
  EXPECT_EQ(sign_of(root(root(root(17)) * root(root(17))) - root(root(17))), 0);
  EXPECT_EQ(sign_of(root(kPi * kPi + 2 * kPi + 1) - kPi - 1), 0);
  EXPECT_EQ(sign_of(root(1 / (3 - root(8))) - 1 - root(2)), 0);
  EXPECT_EQ(sign_of(root(10007 * 10009) - root(10007) * root(10009)), 0);
}

TEST(ExactSign, TellsAConjugateFromZero) {
  // sqrt(5 - 2 sqrt(6)) is sqrt(3) - sqrt(2), not sqrt(2) - sqrt(3), although both have the same square.
  EXPECT_EQ(sign_of(root(5 - 2 * root(6)) - root(3) + root(2)), 0);
  EXPECT_EQ(sign_of(root(5 - 2 * root(6)) - root(2) + root(3)), 1);
  EXPECT_EQ(sign_of(root(5 - 2 * root(6)) - root(3) + root(2) - exact_decimal("1e-390")), -1);
}

TEST(ExactSign, IsUnknownOfSymbols) {
  const GiNaC::symbol m("m");
  EXPECT_EQ(sign_of(m), std::nullopt);
  EXPECT_EQ(sign_of(-root(2) * m), std::nullopt);
  EXPECT_FALSE(is_negative(-m));
  EXPECT_FALSE(is_below(m, m + 1) && is_below(m + 1, m));
}

TEST(ExactSign, IsRefusedBeyondTwelveRootsThatCancel) {
  Number all = 0, square = 0;
  for (const int prime : {2, 3, 5, 7, 11, 13, 17, 19}) all += root(root(prime) + 1);
  square = all.expand() * all;
  EXPECT_THROW(sign_of(root(square.expand()) - all), Failure);
}

TEST(ExactSign, LetsVanishSeeRootsThatCancel) {
  EXPECT_TRUE(vanishes(root(5 + 2 * root(6)) - root(2) - root(3)));
  EXPECT_FALSE(vanishes(root(5 + 2 * root(6)) - root(2) - root(3) + exact_decimal("1e-390")));
}

TEST(ExactSign, FindsInertiasThatNoBodyHas) {
  const Mat3 negative = {Vec3{-root(2), 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  EXPECT_EQ(fault_of_inertia(negative), InertiaFault::not_positive_semidefinite);
  const Mat3 beyond_sum = {Vec3{root(2), 0, 0}, Vec3{0, root(3), 0}, Vec3{0, 0, kPi + exact_decimal("0.005")}};
  EXPECT_EQ(fault_of_inertia(beyond_sum), InertiaFault::triangle_inequality);
  const Mat3 disc = {Vec3{root(2), 0, 0}, Vec3{0, root(3), 0}, Vec3{0, 0, root(5 + 2 * root(6))}};
  EXPECT_EQ(fault_of_inertia(disc), std::nullopt);
}

TEST(ExactSign, TurnsAnAxisTheWayThatItPoints) {
  const Mat3 R = rotation_onto({2 - root(2), 0, 0});
  EXPECT_TRUE(vanishes(R[0][2] - 1));
  const Mat3 S = rotation_onto({root(2) - 2, 0, 0});
  EXPECT_TRUE(vanishes(S[0][2] + 1));
}

}  // namespace
}  // namespace flatdyn
