// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/notation/combination_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "derivation/parameters/unidentifiable.hpp"
#include "report/base_report.hpp"
#include "support/robot_models.hpp"

namespace flatdyn {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using testing::model_of;

std::vector<std::string> combinations(const Mechanism& mechanism, ParameterSet set, ParameterFrames frames) {
  const BaseParameters base = base_parameters(mechanism, set);
  const Combinations in_frames(mechanism, base, frames, set);
  std::vector<std::string> texts;
  for (int k = 0; k < base.size(); ++k) texts.push_back(in_frames.text(k));
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

TEST(Combinations, AreOfCanonicalParametersOnRequest) {
  EXPECT_THAT(combinations(model_of("planar_2r.toml").mechanism, ParameterSet::nonzero, ParameterFrames::canonical),
              ElementsAre("m1lx + a_1 m2", "I1zz + k_r1^2 Im1 + a_1^2 m2", "m2lx", "I2zz", "Im2"));
  EXPECT_THAT(combinations(model_of("ur5.urdf").mechanism, ParameterSet::given, ParameterFrames::canonical),
              Contains("I5xx - I5yy + I6yy"));
}

// Standard DH: the frame of a link is at its far end.
TEST(Combinations, AreOfTheFilesParameters) {
  EXPECT_THAT(
      combinations(model_of("planar_2r.toml").mechanism, ParameterSet::nonzero, ParameterFrames::file),
      ElementsAre("mlx(link1) + a_1 m(link1) + a_1 m(link2)",
                  "Izz(link1) + a_1^2 m(link1) + 2 a_1 mlx(link1) + k_r1^2 Im(theta_1) + a_1^2 m(link2)",
                  "mlx(link2) + a_2 m(link2)", "Izz(link2) + a_2^2 m(link2) + 2 a_2 mlx(link2)", "Im(theta_2)"));
}

TEST(Combinations, BeginWithTheKindThatIsKept) {
  EXPECT_THAT(combinations(model_of("ur5.urdf").mechanism, ParameterSet::given, ParameterFrames::file),
              IsSupersetOf({"mlx(forearm_link) - 0.39225 m(wrist_1_link) - 0.39225 m(wrist_2_link) - "
                            "0.39225 m(wrist_3_link)",
                            "Ixx(wrist_2_link) - Iyy(wrist_2_link) + 0.00677329 m(wrist_3_link) + "
                            "0.1646 mlz(wrist_3_link) + Iyy(wrist_3_link)",
                            "Ixz(wrist_3_link) - 0.0823 mlx(wrist_3_link)"}));
}

TEST(Combinations, HaveTheNamesInPiWhereLinkFramesAreCanonical) {
  for (const ParameterFrames frames : {ParameterFrames::file, ParameterFrames::canonical}) {
    EXPECT_THAT(combinations(model_of("rx90.toml").mechanism, ParameterSet::given, frames),
                Contains("m2lx + 0.45 m3 + 0.45 m4 + 0.45 m5 + 0.45 m6"));
  }
}

TEST(Combinations, BreakLinesAtSigns) {
  const Mechanism mechanism = model_of("ur5.urdf").mechanism;
  const Combinations in_file(mechanism, base_parameters(mechanism), ParameterFrames::file);
  EXPECT_THAT(in_file.lines(8, 60), ElementsAre("mlx(forearm_link) - 0.39225 m(wrist_1_link)",
                                                "- 0.39225 m(wrist_2_link) - 0.39225 m(wrist_3_link)"));
  EXPECT_THAT(in_file.lines(8, 1), ::testing::SizeIs(4));
}

TEST(Unidentifiable, SaysWhy) {
  const Mechanism mechanism = model_of("ur5.urdf").mechanism;
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
  const Mechanism mechanism = model_of("cartesian_2.toml").mechanism;
  for (const Unidentifiable& each : unidentifiable(mechanism, base_parameters(mechanism), ParameterSet::inertial)) {
    EXPECT_THAT(each.reason, HasSubstr("never turns")) << parameter_name(each.index);
  }
}

TEST(Unidentifiable, OfLinksThatTurnAboutOneDirection) {
  const Mechanism mechanism = model_of("scara.toml").mechanism;
  std::map<std::string, std::string> why;
  for (const Unidentifiable& each : unidentifiable(mechanism, base_parameters(mechanism), ParameterSet::given)) {
    why[parameter_name(each.index)] = each.reason;
  }
  EXPECT_THAT(why["I2yy"], HasSubstr("only turns about one direction"));
  EXPECT_THAT(why["m4lz"], HasSubstr("mass moved along it makes no difference"));
  EXPECT_FALSE(why.contains("I2zz"));
}

TEST(Unidentifiable, OfTheFilesParametersSaysWhy) {
  const Mechanism mechanism = model_of("humanoid32.urdf").mechanism;
  const std::vector<FileParameter> parameters = file_parameters(mechanism, ParameterSet::given);
  std::map<std::string, std::string> why;
  for (const Unidentifiable& each : unidentifiable_in_file(mechanism, base_parameters(mechanism), parameters)) {
    why[parameters[static_cast<std::size_t>(each.index)].name] = each.reason;
  }
  EXPECT_THAT(why["mly(R_HIP_P_S)"], HasSubstr("mass on it stays where it is"));  // its joint turns about y
  EXPECT_THAT(why["Izz(R_HIP_P_S)"], HasSubstr("this moment is about another"));
  // The origin of its frame is where the three axes of the hip meet.
  EXPECT_THAT(why["m(R_HIP_Y_S)"], HasSubstr("parameters of link \"R_HIP_R_S\""));
  EXPECT_FALSE(why.contains("Iyy(R_HIP_P_S)"));
}

TEST(BaseReport, HasEachCombinationAndItsValue) {
  const Mechanism mechanism = model_of("planar_2r_example_7_2.toml").mechanism;
  const auto json = base_json(mechanism, ParameterSet::nonzero, ParameterFrames::file);
  EXPECT_EQ(json.at("frames"), "file");
  EXPECT_EQ(json.at("file_parameters").at("m(link1)"), 55.0);  // with the motor of joint 2
  const auto& parameters = json.at("base_parameters");
  ASSERT_EQ(parameters.size(), 5u);
  EXPECT_EQ(parameters[0].at("kept"), "m1lx");
  EXPECT_EQ(parameters[0].at("combination"), "m1lx + m2");
  EXPECT_EQ(parameters[0].at("file_combination"), "mlx(link1) + m(link1) + m(link2)");
  EXPECT_EQ(parameters[0].at("value"), 80.0);  // 55 - 25 + 50
  EXPECT_EQ(parameters[1].at("coefficients").at("Im1"), "10000");
  EXPECT_EQ(parameters[1].at("file_coefficients").at("Im(theta_1)"), "10000");
}

TEST(BaseReport, SaysTheFrames) {
  const Mechanism mechanism = model_of("planar_2r_example_7_2.toml").mechanism;
  const std::string canonical = describe_base(mechanism, ParameterSet::nonzero, ParameterFrames::canonical);
  EXPECT_THAT(canonical, HasSubstr(", in canonical frames (z along the joint's axis): link i is moved by"));
  EXPECT_THAT(canonical, HasSubstr("not identifiable at all:\n  m1: link \"link1\""));
  EXPECT_FALSE(base_json(mechanism, ParameterSet::nonzero, ParameterFrames::canonical).contains("file_parameters"));
  const std::string in_file = describe_base(mechanism, ParameterSet::nonzero, ParameterFrames::file);
  EXPECT_THAT(in_file, HasSubstr(", in the link frames of the robot file: m(L) is the mass of link L"));
  EXPECT_THAT(in_file, HasSubstr("0     m1lx  80      mlx(link1) + m(link1) + m(link2)\n"));
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
