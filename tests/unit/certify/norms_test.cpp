// SPDX-License-Identifier: GPL-2.0-or-later
// Bounds of intermediate results that are known by hand.
#include "proof/certify/norms.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <tuple>

#include "base/diagnostics/diagnostics.hpp"
#include "robot/model/rounded_up.hpp"

namespace flatdyn {
namespace {

using ::testing::AllOf;
using ::testing::Ge;
using ::testing::Le;

// Velocities are bounded by 3, 4, 3, 4, …
double limit_of_norms_test(const Input& input) { return input.index % 2 == 0 ? 3 : 4; }

class NormsTest : public ::testing::Test {
 protected:
  int speed(int k) { return lines_.input({InputKind::qd, k}); }
  Norms norms() const {
    const RoundingFormat& format = rounding_format("double");
    return {lines_, lines_.size(), {format, 0x1p-53, [](double) { return 0.0; }}, limit_of_norms_test};
  }
  std::pair<int, int> rotated(int joint, int x, int y) {
    const int s = lines_.sine(joint), c = lines_.cosine(joint);
    return {lines_.subtract(lines_.multiply(c, x), lines_.multiply(s, y)),
            lines_.add(lines_.multiply(s, x), lines_.multiply(c, y))};
  }

  StraightLine lines_;
};

// Matches from the value to half a percent more, which covers the four digits of rounded bounds.
auto just_above(double value) { return AllOf(Ge(value), Le(1.005 * value)); }

TEST_F(NormsTest, ARotationKeepsTheNorm) {
  std::pair<int, int> x = {speed(0), speed(1)};
  for (int joint = 0; joint < 3; ++joint) x = rotated(joint, x.first, x.second);
  Norms of = norms();
  EXPECT_THAT(of.largest(x.first), just_above(5));  // and not 7 * 2 * 2
  EXPECT_THAT(of.largest(x.second), just_above(5));
}

TEST_F(NormsTest, RotationsAboutDifferentAxesKeepIt) {
  // (x, y, z) rotated about z, then about x, then about z again: a component is never longer than (3, 4, 3).
  auto [x, y] = rotated(0, speed(0), speed(1));
  auto [y2, z2] = rotated(1, y, speed(2));
  auto [x3, y3] = rotated(2, x, y2);
  Norms of = norms();
  for (const int component : {x3, y3, z2}) EXPECT_LE(of.largest(component), 1.005 * std::sqrt(34.0));
  EXPECT_THAT(of.largest(x3), just_above(std::sqrt(34.0)));
}

// Almost: after a twist, the rest of a vector contains a part that does not rotate with the whole.
TEST_F(NormsTest, ConstantTwistsBetweenThemNearlyKeepIt) {
  // Sines and cosines of 1 rad as literals: rotations up to rounding.
  const int s = lines_.constant(0.8414709848078965), c = lines_.constant(0.5403023058681398);
  int x = speed(0), y = speed(1), z = speed(2);
  for (int joint = 0; joint < 4; ++joint) {
    std::tie(x, y) = rotated(joint, x, y);
    const int y_before = y;
    y = lines_.subtract(lines_.multiply(c, y), lines_.multiply(s, z));
    z = lines_.add(lines_.multiply(s, y_before), lines_.multiply(c, z));
  }
  Norms of = norms();
  for (const int component : {x, y, z}) EXPECT_LE(of.largest(component), 1.45 * std::sqrt(34.0));
}

TEST_F(NormsTest, ASineOfASumTurns) {
  const auto [c, s] = rotated(1, lines_.cosine(0), lines_.sine(0));  // sine and cosine of q_0 + q_1
  const int x = speed(0), y = speed(1);
  const int turned = lines_.subtract(lines_.multiply(c, x), lines_.multiply(s, y));
  Norms of = norms();
  EXPECT_THAT(of.largest(turned), just_above(5));
}

TEST_F(NormsTest, AProductWithASumIsMultipliedOut) {
  const int x = speed(0), y = speed(1), sum = lines_.add(x, y);
  const int rest =
      lines_.subtract(lines_.multiply(sum, sum), lines_.multiply(lines_.multiply(x, sum), lines_.constant(2)));
  Norms of = norms();
  EXPECT_THAT(of.largest(rest), just_above(25));  // y^2 - x^2, as x^2 and y^2; and not 49 + 42
}

// Each of the two is at most 5, but not both at the same time.
TEST_F(NormsTest, ProductsOfComponentsOfOneVector) {
  const auto [x, y] = rotated(0, speed(0), speed(1));
  Norms of = norms();
  EXPECT_THAT(of.largest(lines_.multiply(x, y)), just_above(12.5));
}

TEST_F(NormsTest, InfiniteConstantsOverflow) {
  const int infinite = lines_.constant(std::numeric_limits<double>::infinity());
  Norms of = norms();
  EXPECT_THROW(of.largest(infinite), Failure);
}

TEST_F(NormsTest, SumsAndProductsAddAndMultiply) {
  const int sum = lines_.add(speed(0), speed(1)), product = lines_.multiply(speed(0), speed(1));
  const int both = lines_.subtract(product, sum), times_two = lines_.multiply(lines_.constant(-2), both);
  Norms of = norms();
  EXPECT_THAT(of.largest(sum), just_above(7));
  EXPECT_THAT(of.largest(product), just_above(12));
  EXPECT_THAT(of.largest(both), just_above(19));
  EXPECT_THAT(of.largest(times_two), just_above(38));
}

TEST_F(NormsTest, TermsThatCancelAreGone) {
  const int sum = lines_.add(speed(0), speed(1));
  Norms of = norms();
  const int rest = lines_.subtract(sum, speed(0));
  EXPECT_THAT(of.largest(rest), just_above(4));
}

TEST_F(NormsTest, ErrorsAreHalfAUnitOfTheLastPlace) {
  const int sum = lines_.add(speed(0), speed(1));                // within 7: units of 2^-50
  const int doubled = lines_.multiply(lines_.constant(2), sum);  // exact
  const int negative = lines_.negate(sum);
  const int sine = lines_.sine(0);
  Norms of = norms();
  EXPECT_EQ(of.own_error(sum), 0x1p-51);
  EXPECT_EQ(of.own_error(doubled), 0);
  EXPECT_EQ(of.own_error(negative), 0);
  EXPECT_EQ(of.own_error(sine), 0x1p-53);
  EXPECT_EQ(of.own_error(speed(0)), 0);
}

TEST_F(NormsTest, ASineIsOffByWhatItsAngleIsToo) {
  const int angle = lines_.multiply(lines_.constant(0.1), lines_.input({InputKind::q, 1}));  // up to 0.4
  EXPECT_THAT(norms().own_error(lines_.sine(2, angle)), just_above(0x1p-53 + 0x1p-55));
  EXPECT_EQ(norms().own_error(lines_.sine(1)), 0x1p-53);
}

TEST_F(NormsTest, RefusesDivisions) {
  const int quotient = lines_.divide(speed(0), speed(1));
  Norms of = norms();
  EXPECT_THROW(of.largest(quotient), Failure);
}

TEST_F(NormsTest, TakesTheSignOfWhatIsExact) {
  const int sign = lines_.sign(speed(0)), of_sum = lines_.sign(lines_.add(speed(0), speed(1)));
  Norms of = norms();
  EXPECT_THAT(of.largest(sign), just_above(1));
  EXPECT_THROW(of.largest(of_sum), Failure);
}

TEST(RoundingFormat, KnowsHalfAUnitOfTheLastPlace) {
  EXPECT_EQ(rounding_format("double").half_ulp(1), 0x1p-53);
  EXPECT_EQ(rounding_format("double").half_ulp(0.999), 0x1p-54);
  EXPECT_EQ(rounding_format("float").half_ulp(5), 0x1p-22);
  EXPECT_EQ(rounding_format("float").half_ulp(1e-44), 0x1p-150);
  EXPECT_EQ(rounding_format("double").half_ulp(1e-320), 0x1p-1074);
  EXPECT_EQ(rounding_format("double").half_ulp(0), 0);
}

TEST(RoundingFormat, RoundsLiteralsAndInputs) {
  EXPECT_EQ(rounding_format("double").rounded(0.1), 0.1);
  EXPECT_EQ(rounding_format("float").rounded(0.1), static_cast<double>(0.1F));
  EXPECT_GT(static_cast<double>(0.1F), 0.1);
  EXPECT_LT(rounding_format("float").toward_zero(0.1), 0.1);
  EXPECT_LT(rounding_format("float").toward_zero(-0.1), 0.0);
  EXPECT_GT(rounding_format("float").toward_zero(-0.1), -0.1);
}

TEST(RoundedUp, IsFourDigitsAndNeverLess) {
  for (const double value : {1.0, 0.12341, 9.9999, 1.2345e-13, 7e20}) {
    EXPECT_GE(rounded_up(value, kBoundDigits), value);
    EXPECT_LE(rounded_up(value, kBoundDigits), value * 1.0015);
    EXPECT_EQ(std::stod(bound_text(rounded_up(value, kBoundDigits))), rounded_up(value, kBoundDigits));
  }
}

}  // namespace
}  // namespace flatdyn
