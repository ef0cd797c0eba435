// SPDX-License-Identifier: GPL-2.0-or-later
// `flatdyn certify`: its table, its files, its exit codes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

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
                           "seen: the largest at 5000 states, half of them random", "double is enough: "}) {
    EXPECT_THAT(outcome.out, HasSubstr(text));
  }
  EXPECT_THAT(outcome.out, HasSubstr("exact\n"));        // b_22, which is a constant
  EXPECT_THAT(outcome.out, Not(HasSubstr("flatdyn:")));  // nothing is left that Gappa did not prove
}

TEST(Certify, BoundsDerivativesForWeightsAndDirectionsUpToOne) {
  const Outcome outcome =
      run_flatdyn(std::string(kPlanar) + "--states 500 --time-limit 0 --functions vjp:gravity,jvp:gravity,jac:gravity");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  for (const char* text : {"vjp:gravity: bounds in", "q_bar[0]", "dg[0]", "dg_dq[0]"}) {
    EXPECT_THAT(outcome.out, HasSubstr(text));
  }
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
  // Roundings of two functions, two torques, b_11 and b_12 (b_22 is exact), and four about sines.
  EXPECT_EQ(scripts, 2 + 2 + 2 + 4);
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

// The arm of docs/certificates.md in a short form; the long form, with more arms and with Gappa, is there.
TEST(Certify, OfAnArmWithRandomTwistsIsWithin300TimesWhatIsSeen) {
  const Scratch scratch;
  const std::string make =
      "/usr/bin/python3 " FLATDYN_SOURCE_DIR "/docs/examples/random_arms.py '" + scratch.path() + "' 7 3";
  ASSERT_EQ(std::system(make.c_str()), 0);
  const Outcome outcome =
      run_flatdyn("certify '" + scratch.path("3.toml") + "' -q --json --states 200000 --time-limit 0");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json functions = json::parse(outcome.out).at("functions");
  ASSERT_EQ(functions.size(), 2u);
  for (const json& function : functions) {
    EXPECT_GE(function.at("outputs").size(), 7u);
    for (const json& output : function.at("outputs")) {
      EXPECT_LE(output.at("bound"), 300 * output.at("seen").get<double>()) << output;
      EXPECT_GE(output.at("bound"), output.at("seen").get<double>()) << output;
    }
  }
}

TEST(Certify, SaysWhetherFloatIsEnough) {
  const std::string in_float = kPlanar + std::string("-q --functions inverse_dynamics --scalar float --states 5000 ");
  EXPECT_THAT(run_flatdyn(in_float + "--enough 5").out,
              HasSubstr("float is enough: no torque is off by more than 5 %"));
  EXPECT_THAT(run_flatdyn(in_float + "--enough 1e-7").out,
              HasSubstr("float is not enough: errors of more than 1e-07 %"));
}

// A program that passes sines of its own, wrong by the declared error times -1 or 1, chosen by the bits of a number.
constexpr const char* kWithSinesThatAreOff = R"(#include <cstdio>
#include <random>
#include "planar_2r_example_7_2.hpp"
namespace robot = planar_2r_example_7_2;
struct SinCosThatIsOff {
  mutable std::mt19937 bits;
  float off(double x) const { return static_cast<float>(x + (bits() % 2 ? ULP - 1 : 1 - ULP) * 0x1p-24); }
  template <template <int...> class Joints, int... joint>
  void operator()(const float* q, Joints<joint...>, float* s, float* c) const {
    ((s[joint] = off(std::sin(double(q[joint]))), c[joint] = off(std::cos(double(q[joint])))), ...);
  }
};
int main() {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> part(-1, 1);
  const SinCosThatIsOff sines{random};
  double largest[2] = {};
  for (int k = 0; k < 100000; ++k) {
    float q[2], qd[2], qdd[2], tau[2];
    double Q[2], Qd[2], Qdd[2], exact[2];
    for (int i = 0; i < 2; ++i) {
      Q[i] = q[i] = float(4 * part(random));
      Qd[i] = qd[i] = float(robot::velocity_limit[i] * part(random));
      Qdd[i] = qdd[i] = float(robot::acceleration_limit[i] * part(random));
    }
    robot::inverse_dynamics(q, qd, qdd, tau, sines);
    robot::inverse_dynamics(Q, Qd, Qdd, exact);
    for (int i = 0; i < 2; ++i) largest[i] = std::fmax(largest[i], std::fabs(tau[i] - exact[i]));
  }
  std::printf("[%.17g, %.17g]", largest[0], largest[1]);
  return robot::rounding_is_as_written<float>() ? 0 : 1;
}
)";

std::vector<double> inverse_dynamics_bounds(const Scratch& scratch, const std::string& options) {
  const Outcome outcome = run_flatdyn(kPlanar + std::string("-q --functions inverse_dynamics --states 2000 ") +
                                      options + " -o " + scratch.path());
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  std::vector<double> bounds;
  const json certificate = json::parse(scratch.read("planar_2r_example_7_2.certificate.json"));
  for (const json& output : certificate.at("functions").at(0).at("outputs")) bounds.push_back(output.at("bound"));
  return bounds;
}

// The bound holds for the compiled text with the caller's sines.
TEST(Certify, HoldsForSinesOfTheCallersOwn) {
  const Scratch scratch;
  const std::vector<double> good = inverse_dynamics_bounds(scratch, "--scalar float");
  const std::vector<double> bounds = inverse_dynamics_bounds(scratch, "--scalar float --trigonometry-ulp 500");
  EXPECT_THAT(scratch.read("planar_2r_example_7_2.certificate.md"),
              HasSubstr("sines and cosines that are off by no more than 500 ulp, 2.980e-05"));
  EXPECT_EQ(json::parse(scratch.read("planar_2r_example_7_2.certificate.json")).at("trigonometry_ulp"), 500);
  scratch.write("main.cpp", kWithSinesThatAreOff);
  const std::string folder = scratch.path();
  ASSERT_EQ(std::system(("cd '" + folder + "' && c++ -std=c++17 -O2 -ffp-contract=off -DULP=500 main.cpp -o off && " +
                         "./off > seen")
                            .c_str()),
            0);
  const json seen = json::parse(scratch.read("seen"));
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_LE(seen[k].get<double>(), bounds[k]);
    EXPECT_GT(seen[k].get<double>(), bounds[k] / 10);
    EXPECT_GT(seen[k].get<double>(), good[k]);
  }
}

TEST(Certify, RefusesSinesThatAreNone) {
  const Outcome outcome = run_flatdyn(kPlanar + std::string("--scalar float --trigonometry-ulp 1e8"));
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("sines and cosines that are off by 6"));
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

constexpr const char* kFreeBody = R"(name = "body"
[base]
motion = "floating"
mass = 2
com = [0.01, 0.02, 0.3]
inertia = { xx = 1, yy = 2, zz = 3 }
inertia_about = "com"
)";

TEST(Certify, AsksForTheLimitsOfAFloatingBase) {
  const Scratch scratch;
  scratch.write("body.toml", kFreeBody);
  const std::string certify = "certify " + scratch.path("body.toml") + " -q --functions inverse_dynamics ";
  const Outcome none = run_flatdyn(certify);
  EXPECT_EQ(none.code, 4);
  EXPECT_THAT(none.err, HasSubstr("the floating base has no limit `angular_velocity`"));
  EXPECT_THAT(none.err, HasSubstr("[base_limits] of the scene"));
  scratch.write("scene.toml",
                "[base_limits]\nlinear_velocity = 2\nangular_velocity = 3\nlinear_acceleration = 10\n"
                "angular_acceleration = 20\nforce = 100\nmoment = 200\n");
  const std::string scene = "--scene " + scratch.path("scene.toml");
  const Outcome proven = run_flatdyn(certify + scene + " --states 5000 -o " + scratch.path("out"));
  ASSERT_EQ(proven.code, 0) << proven.err;
  const json certificate = json::parse(scratch.read("out/body.certificate.json"));
  const json& outputs = certificate.at("functions").at(0).at("outputs");
  ASSERT_EQ(outputs.size(), 6u);
  for (const json& output : outputs) {
    EXPECT_EQ(output.at("gappa"), "proven");
    EXPECT_LE(output.at("bound"), 10 * output.at("seen").get<double>()) << output;
  }
  EXPECT_EQ(outputs.at(0).at("unit"), "N");
  EXPECT_EQ(outputs.at(0).at("effort_limit"), 100);
  EXPECT_EQ(outputs.at(5).at("effort_limit"), 200);
  EXPECT_THAT(scratch.read("out/body.hpp"), HasSubstr("base_limits.angular_velocity = 3"));
  const Outcome part = run_flatdyn("generate " + scratch.path("body.toml") + " -q --functions inverse_dynamics -o " +
                                   scratch.path("part") + " --error-budget 1% " + scene);
  EXPECT_EQ(part.code, 0) << part.err;
  EXPECT_THAT(scratch.read("part/body.hpp"), HasSubstr("force and moment on the base"));
  scratch.write("scene.toml", "[base_limits]\nforce = 0\n");
  const Outcome zero = run_flatdyn(certify + scene);
  EXPECT_EQ(zero.code, 3);
  EXPECT_THAT(zero.err, HasSubstr("scene.toml:2: error: base_limits: force is not positive"));
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
