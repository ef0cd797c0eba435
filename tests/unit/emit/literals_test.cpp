// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/emit/literals.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

#include "base/diagnostics/diagnostics.hpp"

namespace flatdyn {
namespace {

using Integer = Rational::Integer;

Rational power_of_two(int exponent) {
  const Rational magnitude(Integer(1) << static_cast<unsigned long>(std::abs(exponent)));
  return exponent < 0 ? Rational(1 / magnitude) : magnitude;
}

std::string literal(const char* exact) { return decimal_literal(Rational(exact)); }

TEST(Literals, AreShortAndFloating) {
  EXPECT_EQ(literal("0"), "0.0");
  EXPECT_EQ(literal("2"), "2.0");
  EXPECT_EQ(literal("-7"), "-7.0");
  EXPECT_EQ(literal("1/10"), "0.1");
  EXPECT_EQ(literal("-981/100"), "-9.81");
  EXPECT_EQ(literal("1/3"), "0.3333333333333333");
  EXPECT_EQ(literal("2/3"), "0.6666666666666666");
  EXPECT_EQ(literal("1/10000"), "0.0001");
  EXPECT_EQ(literal("3/20000000"), "1.5e-07");
  EXPECT_EQ(literal("123456789012345"), "123456789012345.0");
  EXPECT_EQ(literal("10000000000000000"), "1e+16");
}

TEST(Literals, ReadBackAsTheNearestDouble) {
  EXPECT_EQ(nearest_double(Rational("1/" + ("1" + std::string(300, '0')))), 1e-300);
  EXPECT_EQ(nearest_double(Rational("1" + std::string(308, '0'))), 1e308);
  EXPECT_EQ(nearest_double(Rational("1/10")), 0.1);
  EXPECT_EQ(nearest_double(power_of_two(-1074)), std::numeric_limits<double>::denorm_min());
}

// A tie between two doubles is rounded to the even one; anything beyond the tie is not.
TEST(Literals, RoundHalfToEven) {
  const Rational ulp = power_of_two(-52);
  EXPECT_EQ(nearest_double(1 + ulp / 2), 1.0);
  EXPECT_EQ(nearest_double(1 + ulp * Rational(3) / 2), 1.0 + 2 * std::numeric_limits<double>::epsilon());
  EXPECT_EQ(nearest_double(1 + ulp / 2 + power_of_two(-500)), 1.0 + std::numeric_limits<double>::epsilon());
  EXPECT_EQ(nearest_double(2 - ulp / 4), 2.0);  // rounds up into the next binade
  const Rational least = power_of_two(-1074);
  EXPECT_EQ(nearest_double(least * Rational(3) / 2), 2 * std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(nearest_double(-least * Rational(5) / 2), -2 * std::numeric_limits<double>::denorm_min());
}

TEST(Literals, RandomDoublesSurviveExactly) {
  std::mt19937_64 random(7);
  for (int k = 0; k < 20000; ++k) {
    const auto value = std::bit_cast<double>(static_cast<std::uint64_t>(random()));
    if (!std::isfinite(value) || value == 0) continue;
    const std::string text = decimal_literal(Rational(value));
    EXPECT_EQ(std::strtod(text.c_str(), nullptr), value) << text;
    EXPECT_NE(text.find_first_of(".e"), std::string::npos) << text;
  }
}

TEST(Literals, RefuseWhatNoDoubleCanHold) {
  EXPECT_THROW(nearest_double(Rational("1" + std::string(309, '0'))), Failure);
  EXPECT_THROW(nearest_double(power_of_two(-1076)), Failure);
  EXPECT_THROW(nearest_double(power_of_two(1024) - power_of_two(969)), Failure);  // rounds up to infinity
  try {
    nearest_double(power_of_two(2000));
    FAIL();
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.kind(), FailureKind::input);
    EXPECT_STREQ(failure.what(), "a constant of the model is out of the range of double, about 2^2000");
  }
}

}  // namespace
}  // namespace flatdyn
