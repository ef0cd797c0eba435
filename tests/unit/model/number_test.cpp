// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/number.hpp"

#include <gtest/gtest.h>

#include "robot/model/field_mechanism.hpp"

namespace flatdyn {
namespace {

TEST(ExactDecimal, IsTheRationalThatIsWritten) {
  EXPECT_EQ(exact_decimal("0.1"), GiNaC::numeric(1, 10));
  EXPECT_EQ(exact_decimal("-1.5e-3"), GiNaC::numeric(-3, 2000));
  EXPECT_EQ(exact_decimal("+12."), 12);
  EXPECT_EQ(exact_decimal(".25E2"), 25);
}

TEST(ExactDecimal, RefusesWhatIsNoFiniteDecimal) {
  for (const char* text : {"", "-", ".", "1e", "nan", "inf", "1.2.3", "1 ", "0x10", "1e99999", "1e401"}) {
    EXPECT_THROW(exact_decimal(text), std::invalid_argument) << text;
  }
}

TEST(ToDecimal, KeepsAllDigitsAskedFor) {
  EXPECT_EQ(to_decimal(GiNaC::Pi / 3, 40).substr(0, 42), "1.0471975511965977461542144610931676280657");
  EXPECT_EQ(to_decimal(exact_decimal("0.0825"), 17), "0.0825");
  EXPECT_THROW(to_decimal(GiNaC::symbol("x"), 10), std::domain_error);
}

TEST(ToDecimal, KeepsThemWhereTermsCancel) {
  const Number rest = GiNaC::sqrt(Number(2)) - exact_decimal("1.41421356237309504880168872420969807856967187537694");
  EXPECT_EQ(to_decimal(rest, 40).substr(0, 30), "8.0731766797379907324784621070");
  EXPECT_EQ(to_decimal(GiNaC::sqrt(Number(8)) - 2 * GiNaC::sqrt(Number(2)), 10), "0.0");
}

TEST(ToRational, IsExactBothWays) {
  for (const char* text : {"0", "-1", "9223372036854775807", "-9223372036854775808", "9223372036854775808",
                           "-1606938044258990275541962092341162602522202993782792835301376", "2/3",
                           "-18446744073709551616/3", "1/340282366920938463463374607431768211456"}) {
    const Number number = GiNaC::numeric(text);
    EXPECT_EQ(to_rational(number).str(), text);
    EXPECT_TRUE(to_number(Rational(std::string(text))).is_equal(number)) << text;
  }
}

TEST(NearestDouble, GoesDownToZeroWithoutComplaint) {
  EXPECT_EQ(nearest_double(exact_decimal("-0.1")), -0.1);
  EXPECT_EQ(nearest_double(GiNaC::Pi), 3.141592653589793);
  EXPECT_EQ(nearest_double(exact_decimal("1e-308")), 1e-308);
  EXPECT_EQ(nearest_double(exact_decimal("1e-310")), 1e-310);
  EXPECT_EQ(nearest_double(exact_decimal("1e-400")), 0);
}

TEST(Vanishes, SeesThroughUnexpandedSums) {
  const GiNaC::symbol x("x");
  EXPECT_TRUE(vanishes(GiNaC::pow(x + 1, 2) - x * x - 2 * x - 1));
  EXPECT_FALSE(vanishes(x - 1));
}

}  // namespace
}  // namespace flatdyn
