// SPDX-License-Identifier: GPL-2.0-or-later
#include "symbolic/notation/combination_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/base_report.hpp"
#include "support/robot_models.hpp"
#include "symbolic/parameters/unidentifiable.hpp"

namespace flatdyn {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<std::string> combinations(const Mechanism& mechanism, ParameterSet set) {
  const BaseParameters base = base_parameters(mechanism, set);
  std::vector<std::string> texts;
  for (int k = 0; k < base.size(); ++k) texts.push_back(combination_text(base, k));
  return texts;
}

TEST(CoefficientText, IsWhatPeopleWrite) {
  const GiNaC::symbol a("a_1"), b("b");
  EXPECT_EQ(coefficient_text(1), "1");
  EXPECT_EQ(coefficient_text(-1), "-1");
  EXPECT_EQ(coefficient_text(GiNaC::numeric(-1, 3)), "-1/3");
  EXPECT_EQ(coefficient_text(b * GiNaC::pow(a, 2) * 2), "2 a_1^2 b");
  EXPECT_EQ(coefficient_text(a - b), "(a_1 - b)");
  EXPECT_EQ(coefficient_text(GiNaC::pow(a + b, 2)), "(2 a_1 b + a_1^2 + b^2)");
  EXPECT_EQ(coefficient_text(-a / (b + 1)), "-a_1/(1 + b)");
}

TEST(CombinationText, OfThePlanarArm) {
  EXPECT_THAT(combinations(testing::model_of("planar_2r.toml").mechanism, ParameterSet::nonzero),
              ElementsAre("m1lx + a_1 m2", "I1zz + k_r1^2 Im1 + a_1^2 m2", "m2lx", "I2zz", "Im2"));
}

TEST(CombinationText, OfALinkThatCarriesASkewOne) {
  EXPECT_THAT(combinations(testing::model_of("ur5.urdf").mechanism, ParameterSet::given),
              Contains("I5xx - I5yy + I6yy"));
}

TEST(Unidentifiable, SaysWhy) {
  const Mechanism mechanism = testing::model_of("ur5.urdf").mechanism;
  const BaseParameters base = base_parameters(mechanism);
  std::map<std::string, std::string> why;
  for (const Unidentifiable& each : unidentifiable(mechanism, base, ParameterSet::given)) {
    why[parameter_name(each.index)] = each.reason;
  }
  EXPECT_THAT(why["m1"], HasSubstr("mass on it stays where it is"));
  EXPECT_THAT(why["m1lx"], HasSubstr("gravity does not act about it"));
  EXPECT_THAT(why["I1xy"], HasSubstr("this moment is about another"));
  EXPECT_THAT(why["m2"], HasSubstr("parameters of link \"shoulder_link\" that are not identifiable themselves"));
  EXPECT_EQ(why.size(), 11u);  // eight more of link 1, and m2lz
}

TEST(Unidentifiable, OfLinksThatDoNotTurn) {
  const Mechanism mechanism = testing::model_of("cartesian_2.toml").mechanism;
  for (const Unidentifiable& each : unidentifiable(mechanism, base_parameters(mechanism), ParameterSet::inertial)) {
    EXPECT_THAT(each.reason, HasSubstr("never turns")) << parameter_name(each.index);
  }
}

TEST(Unidentifiable, OfLinksThatTurnAboutOneDirection) {
  const Mechanism mechanism = testing::model_of("scara.toml").mechanism;
  std::map<std::string, std::string> why;
  for (const Unidentifiable& each : unidentifiable(mechanism, base_parameters(mechanism), ParameterSet::given)) {
    why[parameter_name(each.index)] = each.reason;
  }
  EXPECT_THAT(why["I2yy"], HasSubstr("only turns about one direction"));
  EXPECT_THAT(why["m4lz"], HasSubstr("mass moved along it makes no difference"));
  EXPECT_FALSE(why.contains("I2zz"));
}

TEST(BaseReport, HasEachCombinationAndItsValue) {
  const Mechanism mechanism = testing::model_of("planar_2r_example_7_2.toml").mechanism;
  const auto json = base_json(mechanism, ParameterSet::nonzero);
  const auto& parameters = json.at("base_parameters");
  ASSERT_EQ(parameters.size(), 5u);
  EXPECT_EQ(parameters[0].at("kept"), "m1lx");
  EXPECT_EQ(parameters[0].at("combination"), "m1lx + m2");
  EXPECT_EQ(parameters[0].at("value"), 80.0);  // 30 + 1 · 50
  EXPECT_EQ(parameters[1].at("coefficients").at("Im1"), "10000");
  EXPECT_THAT(describe_base(mechanism, ParameterSet::nonzero),
              HasSubstr("not identifiable at all:\n  m1: link \"link1\""));
}

TEST(CoefficientText, HasExactNumbers) {
  const GiNaC::symbol a("a");
  EXPECT_EQ(coefficient_text(GiNaC::numeric(17, 40)), "0.425");
  EXPECT_EQ(coefficient_text(GiNaC::numeric(-180625, 1000000)), "-0.180625");
  EXPECT_EQ(coefficient_text(exact_decimal("0.0000001")), "0.0000001");
  EXPECT_EQ(coefficient_text(exact_decimal("-12.5")), "-12.5");
  EXPECT_EQ(coefficient_text(GiNaC::numeric(3, 10) * a * a), "0.3 a^2");
}

}  // namespace
}  // namespace flatdyn
