// SPDX-License-Identifier: GPL-2.0-or-later
// The numbers that cause a question about units, on both sides of each threshold.
#include "robot/model/unit_plausibility.hpp"

#include <gtest/gtest.h>

namespace flatdyn {
namespace {

Number decimal(const char* text) { return exact_decimal(text); }

Limits within(const char* lower, const char* upper) {
  Limits limits;
  limits.lower = Value{decimal(lower), {}};
  limits.upper = Value{decimal(upper), {}};
  return limits;
}

TEST(UnitPlausibility, AskAboutAnglesBeyondAWholeTurn) {
  for (const char* odd : {"6.3", "-6.3", "90", "-180", "17.3"}) EXPECT_TRUE(may_be_degrees(decimal(odd))) << odd;
  for (const char* fine : {"0", "1.57", "-3.1416", "6.28", "6.2832", "-6.283185308", "5"}) {
    EXPECT_FALSE(may_be_degrees(decimal(fine))) << fine;
  }
}

TEST(UnitPlausibility, TakeExpressionsInPiAsTheyAre) {
  EXPECT_FALSE(may_be_degrees(30 * GiNaC::Pi));
  EXPECT_FALSE(may_be_degrees(GiNaC::symbol("alpha_1")));
  EXPECT_FALSE(limit_may_be_degrees(60 * GiNaC::Pi));
}

TEST(UnitPlausibility, ExpectPositionsWithinTheJointsLimits) {
  EXPECT_FALSE(may_be_degrees(decimal("90"), within("-100", "100"), false));
  EXPECT_TRUE(may_be_degrees(decimal("90"), within("-3", "3"), false));
  EXPECT_FALSE(may_be_degrees(decimal("6"), within("-3", "3"), false));
}

TEST(UnitPlausibility, ExpectAJointWithoutLimitsToTurnOnceAndAContinuousOneMoreOften) {
  EXPECT_TRUE(may_be_degrees(decimal("7"), {}, false));
  EXPECT_FALSE(may_be_degrees(decimal("7"), {}, true));
  EXPECT_FALSE(may_be_degrees(decimal("49.9"), {}, true));
  EXPECT_TRUE(may_be_degrees(decimal("50.1"), {}, true));
  EXPECT_TRUE(may_be_degrees(decimal("-45"), {}, true));
}

TEST(UnitPlausibility, AskAboutLimitsOfManyTurnsUnlessTheyStandForNone) {
  for (const char* odd : {"170", "-360", "100", "50.1", "45", "-30"}) {
    EXPECT_TRUE(limit_may_be_degrees(decimal(odd))) << odd;
  }
  for (const char* fine : {"0", "6.2831853", "12.566", "10", "-49.9", "10001", "1e16"}) {
    EXPECT_FALSE(limit_may_be_degrees(decimal(fine))) << fine;
  }
}

TEST(UnitPlausibility, SayHowManyTurnsItIsAndWhatToWrite) {
  EXPECT_EQ(degrees_question(decimal("90")), "90 rad is 14 turns; were degrees meant?");
  EXPECT_EQ(degrees_question(decimal("-7")), "-7 rad is 1.1 turns; were degrees meant?");
  EXPECT_EQ(radians_text(90, AngleText::expression), "\"pi/2\"");
  EXPECT_EQ(radians_text(-180, AngleText::expression), "\"-pi\"");
  EXPECT_EQ(radians_text(-45, AngleText::expression), "\"-pi/4\"");
  EXPECT_EQ(radians_text(360, AngleText::expression), "\"2*pi\"");
  EXPECT_EQ(radians_text(75, AngleText::expression), "\"5*pi/12\"");
  EXPECT_EQ(radians_text(90, AngleText::decimal), "1.5707963267948966");
  EXPECT_EQ(radians_text(170, AngleText::expression), "2.9670597283903604");
  EXPECT_EQ(radians_text(exact_decimal("1.5e30"), AngleText::expression).substr(0, 4), "2.61");
}

}  // namespace
}  // namespace flatdyn
