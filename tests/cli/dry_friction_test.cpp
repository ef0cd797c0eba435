// SPDX-License-Identifier: GPL-2.0-or-later
// Robots with smooth friction from end to end, in all languages, and what does not take it.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/program.hpp"

namespace flatdyn::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kRubbedArm = R"(name = "arm"
[[link]]
joint = "shoulder"
rpy = ["pi/2", 0, 0]
mass = 3
com = [0.2, 0.1, 0]
viscous = 0.3
coulomb = 0.8
coulomb_speed = 0.05
coulomb_offset = 0.02
limits = {{ lower = -2, upper = 2, velocity = 1, acceleration = 1, effort = 90 }}
[[link]]
joint = "rail"
type = "prismatic"
axis = [1, 1, 0]
mass = 2
coulomb = {}
coulomb_speed = 0.1
{}limits = {{ lower = -1, upper = 1, velocity = 1, acceleration = 1, effort = 90 }}
)";

class DryFriction : public ::testing::Test {
 protected:
  DryFriction() {
    write("{ forward = 0.5, backward = 0.25 }", "");
    scratch.write("smooth.toml", "friction = false\n");
  }

  void write(const std::string& coulomb, const std::string& more) const {
    scratch.write("arm.toml", fmt::format(kRubbedArm, coulomb, more));
  }
  Outcome run(const std::string& command, const std::string& options = "") const {
    return run_flatdyn(fmt::format("{} {} {}", command, scratch.path("arm.toml"), options));
  }

  Scratch scratch;
};

TEST_F(DryFriction, IsVerified) {
  write("0.5", "static = 0.7\nstribeck_speed = 0.2\n");
  const Outcome outcome = run("verify -q --json --states 20",
                              "--functions inverse_dynamics,forward_dynamics,bias,forward_dynamics_derivatives,"
                              "inverse_dynamics_derivatives,vjp:inverse_dynamics,step:rk4");
  ASSERT_EQ(outcome.code, 0) << outcome.err << outcome.out;
  for (const json& function : json::parse(outcome.out)["functions"]) {
    EXPECT_TRUE(function["proven"]) << function;
    EXPECT_LT(function["graph_error"], 1e-16) << function;
  }
}

// The text is read back and proven; that of C has lanes.
TEST_F(DryFriction, IsWrittenInEveryLanguage) {
  for (const char* language : {"c", "javascript", "rust", "cuda"}) {
    const Outcome outcome =
        run("generate -q", fmt::format("--functions inverse_dynamics,vjp:inverse_dynamics --language {} -o {}",
                                       language, scratch.path(language)));
    EXPECT_EQ(outcome.code, 0) << language << ": " << outcome.err;
  }
  for (const char* options : {"--scalar float", "--fma", "--language casadi"}) {
    const Outcome outcome =
        run("generate -q", fmt::format("--functions inverse_dynamics {} -o {}", options, scratch.path("other")));
    EXPECT_EQ(outcome.code, 0) << options << ": " << outcome.err;
  }
}

TEST_F(DryFriction, IsSaid) {
  ASSERT_EQ(run("generate -q", "--functions inverse_dynamics_derivatives -o " + scratch.path("out")).code, 0);
  EXPECT_THAT(scratch.read("out/arm.hpp"), Not(HasSubstr("counts as constant")));
  EXPECT_THAT(run("inspect").out, HasSubstr("F_s = 0.8 N m, smooth around 0.05 rad/s, offset by 0.02 rad/s"));
  EXPECT_THAT(run("inspect").out, HasSubstr(": 0.5 forward, 0.25 backward"));
  EXPECT_THAT(run("derive").out, HasSubstr("tanh((qd_1 + 0.02)/0.05)"));
  EXPECT_EQ(json::parse(run("inspect", "--json").out)["joints"][0]["coulomb_speed"], 0.05);
}

TEST_F(DryFriction, OfThePandaIsReadAndProven) {
  const Outcome outcome =
      run_flatdyn("generate -q docs/examples/panda_friction.toml --functions bias -o " + scratch.path("panda"));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, Not(HasSubstr("warning")));
}

TEST_F(DryFriction, IsLeftOutByAScene) {
  const Outcome outcome = run("generate -q", fmt::format("--functions inverse_dynamics --scene {} -o {}",
                                                         scratch.path("smooth.toml"), scratch.path("out")));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(scratch.read("out/arm.hpp"), Not(HasSubstr("detail::sign")));
}

TEST_F(DryFriction, GoesThroughConvert) {
  ASSERT_EQ(run("convert -q", "-o " + scratch.path("again.toml")).code, 0);
  const std::string again = scratch.read("again.toml");
  EXPECT_THAT(again, HasSubstr("coulomb = 0.8\ncoulomb_speed = 0.05\ncoulomb_offset = 0.02\n"));
  EXPECT_THAT(again, HasSubstr("coulomb = { forward = 0.5, backward = 0.25 }\ncoulomb_speed = 0.1\n"));
  const Outcome urdf = run("convert", "-o " + scratch.path("again.urdf"));
  EXPECT_EQ(urdf.code, 4);
  EXPECT_THAT(urdf.err, HasSubstr("how friction changes with the rate of joint \"shoulder\""));
}

TEST_F(DryFriction, IsRefusedWhereItIsNotKnown) {
  const std::string out = " -o " + scratch.path("out");
  const Outcome regressor = run("generate", "--functions regressor" + out);
  EXPECT_EQ(regressor.code, 4);
  EXPECT_THAT(regressor.err, HasSubstr("friction of joint \"rail\" (forward, backward) is no multiple of F_s"));
  const Outcome certified = run("certify", "--functions inverse_dynamics");
  EXPECT_EQ(certified.code, 4);
  EXPECT_THAT(certified.err, HasSubstr("cannot be certified: it divides"));
  EXPECT_EQ(run("excite", out).code, 4);
}

// Energy goes into friction, and the torques of a fall are zero.
TEST_F(DryFriction, IsSimulated) {
  const Outcome outcome = run("simulate -q", "--duration 0.3 --rate 200 --json -o " + scratch.path("motion.csv"));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_LT(json::parse(outcome.out)["energy_error"], 1e-6);
  const Outcome torques =
      run("torques -q", "--json --trajectory " + scratch.path("motion.csv") + " -o " + scratch.path("torques.csv"));
  ASSERT_EQ(torques.code, 0) << torques.err;
  for (const json& joint : json::parse(torques.out)["joints"]) {
    EXPECT_LT(std::abs(joint["torque"].get<double>()), 1e-12) << joint;
    EXPECT_GT(std::abs(joint["contributions"]["friction"].get<double>()), 0.1) << joint;
  }
}

}  // namespace
}  // namespace flatdyn::testing
