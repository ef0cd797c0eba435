// SPDX-License-Identifier: GPL-2.0-or-later
// `flatdyn certify`: its table, its files, its exit codes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/program.hpp"

namespace flatdyn::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kPlanar =
    "certify robots/planar_2r_example_7_2.toml --scene docs/examples/planar_2r_limits.toml ";

TEST(Certify, PrintsProvenBoundsBesideErrorsSeen) {
  const Outcome outcome = run_flatdyn(std::string(kPlanar) + "--states 5000");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  for (const char* text : {"inverse_dynamics: bounds in", "tau[0]  N m ", "kg m^2", "Gappa\n",
                           "seen: the largest of 5000 random states", "double is enough: "}) {
    EXPECT_THAT(outcome.out, HasSubstr(text));
  }
  EXPECT_THAT(outcome.out, HasSubstr("exact\n"));        // b_22, which is a constant
  EXPECT_THAT(outcome.out, Not(HasSubstr("flatdyn:")));  // nothing is left that Gappa did not prove
}

TEST(Certify, WritesTheHeaderItsCertificateAndScriptsThatGappaAccepts) {
  const Scratch scratch;
  const Outcome outcome = run_flatdyn(kPlanar + std::string("-q --states 5000 -o ") + scratch.path());
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json certificate = json::parse(scratch.read("planar_2r_example_7_2.certificate.json"));
  EXPECT_EQ(certificate.at("functions").at(0).at("outputs").at(0).at("gappa"), "proven");
  EXPECT_THAT(scratch.read("planar_2r_example_7_2.hpp"), HasSubstr("inline void inverse_dynamics("));
  const std::string page = scratch.read("planar_2r_example_7_2.certificate.md");
  EXPECT_THAT(page, HasSubstr("| tau[0] | N m |"));
  EXPECT_THAT(page, HasSubstr(certificate.at("hash").get<std::string>()));
  EXPECT_THAT(page, HasSubstr("`rounding_is_as_written<double>()`"));
  int scripts = 0;
  for (const auto& script : std::filesystem::directory_iterator(scratch.path("planar_2r_example_7_2.gappa"))) {
    EXPECT_EQ(std::system(("gappa '" + script.path().string() + "' > /dev/null 2>&1").c_str()), 0) << script.path();
    ++scripts;
  }
  EXPECT_EQ(scripts, 2 + 2 + 2);  // roundings of two functions, two torques, b_11 and b_12; b_22 is exact
}

TEST(Certify, IsTheSameEachTime) {
  const auto scripts = [] {
    const Scratch scratch;
    EXPECT_EQ(run_flatdyn(kPlanar + std::string("-q --states 500 --time-limit 0 -o ") + scratch.path()).code, 0);
    return scratch.read("planar_2r_example_7_2.certificate.json") +
           scratch.read("planar_2r_example_7_2.gappa/inverse_dynamics.tau_0.g");
  };
  EXPECT_EQ(scripts(), scripts());
}

TEST(Certify, SaysWhetherFloatIsEnough) {
  const std::string in_float = kPlanar + std::string("-q --functions inverse_dynamics --scalar float --states 5000 ");
  EXPECT_THAT(run_flatdyn(in_float + "--enough 5").out,
              HasSubstr("float is enough: no torque is off by more than 5 %"));
  EXPECT_THAT(run_flatdyn(in_float + "--enough 1e-7").out,
              HasSubstr("float is not enough: errors of more than 1e-07 %"));
}

TEST(Certify, WithoutGappaGivesItsOwnBounds) {
  const Scratch scratch;
  const std::string program = FLATDYN_PROGRAM, robot = std::string(FLATDYN_SOURCE_DIR) + "/robots/panda.urdf";
  const std::string command = "PATH=/nowhere " + program + " certify " + robot +
                              " --functions gravity --states 1000 > " + scratch.path("out") + " 2> " +
                              scratch.path("err");
  EXPECT_EQ(std::system(command.c_str()), 0);
  EXPECT_THAT(scratch.read("err"), HasSubstr("Gappa is not there"));
  EXPECT_THAT(scratch.read("out"), HasSubstr("flatdyn\n"));
}

TEST(Certify, EndsWithFourWhereNoBoundIsWithinReach) {
  const Scratch scratch;
  const Outcome divides = run_flatdyn("certify robots/panda.urdf --functions forward_dynamics -o " + scratch.path());
  EXPECT_EQ(divides.code, 4);
  EXPECT_THAT(divides.err, HasSubstr("forward_dynamics cannot be certified"));
  const Outcome unlimited = run_flatdyn("certify robots/ur5.urdf -o " + scratch.path());
  EXPECT_EQ(unlimited.code, 4);
  EXPECT_THAT(unlimited.err, HasSubstr("joint \"shoulder_pan_joint\" has no limit of acceleration"));
  EXPECT_THAT(unlimited.err, HasSubstr("[limits] of the scene"));
  EXPECT_TRUE(scratch.is_empty());
}

}  // namespace
}  // namespace flatdyn::testing
