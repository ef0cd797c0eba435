// SPDX-License-Identifier: GPL-2.0-or-later
// Robots with joint springs from end to end, in all languages, and what leaves springs out.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "cli/program.hpp"

namespace flatdyn::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

constexpr const char* kArm = R"(name = "arm"
[[link]]
joint = "shoulder"
rpy = ["pi/2", 0, 0]
mass = 3
com = [0.2, 0.1, 0]
viscous = 0.3
limits = { lower = -2, upper = 2, velocity = 1, acceleration = 1, effort = 90 }
{}[[link]]
joint = "rail"
type = "prismatic"
axis = [1, 1, 0]
mass = 2
limits = { lower = -1, upper = 1, velocity = 1, acceleration = 1, effort = 90 }
{})";

std::string arm(bool sprung) {
  std::string text = kArm;
  for (const char* spring : {"stiffness = 12\nspring_reference = 0.3\n", "stiffness = 200\n"}) {
    text.replace(text.find("{}"), 2, sprung ? spring : "");
  }
  return text;
}

class SpringsOfARobot : public ::testing::Test {
 protected:
  SpringsOfARobot() {
    scratch.write("arm.toml", arm(true));
    scratch.write("still.toml", "springs = false\n");
  }

  Outcome run(const std::string& command, const std::string& options = "") const {
    return run_flatdyn(fmt::format("{} {} {}", command, scratch.path("arm.toml"), options));
  }

  Scratch scratch;
};

TEST_F(SpringsOfARobot, AreVerified) {
  const Outcome outcome = run("verify -q --json --states 4");
  ASSERT_EQ(outcome.code, 0) << outcome.err << outcome.out;
  for (const json& function : json::parse(outcome.out)["functions"]) {
    EXPECT_TRUE(function["proven"]) << function;
    EXPECT_LT(function["graph_error"], 1e-40) << function;
  }
}

// The text is read back and proven.
TEST_F(SpringsOfARobot, AreWrittenInEveryLanguage) {
  for (const char* language : {"c", "javascript"}) {
    const Outcome outcome = run("generate -q", fmt::format("--language {} -o {}", language, scratch.path(language)));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
  }
}

TEST_F(SpringsOfARobot, AreSaidInTheHeader) {
  ASSERT_EQ(run("generate -q", "-o " + scratch.path("out")).code, 0);
  const std::string header = scratch.read("out/arm.hpp");
  EXPECT_THAT(header, HasSubstr("+ friction + springs"));
  EXPECT_THAT(header, HasSubstr("Potential energy of links, rotors and springs"));
  EXPECT_THAT(run("inspect").out, HasSubstr("spring k = 12 N m/rad, q_0 = 0.3 rad"));
}

// The code is that of the same robot without springs.
TEST_F(SpringsOfARobot, AreLeftOutByAScene) {
  const std::string functions = "-q --functions inverse_dynamics,potential_energy -o ";
  ASSERT_EQ(run("generate", functions + scratch.path("a") + " --scene " + scratch.path("still.toml")).code, 0);
  scratch.write("arm.toml", arm(false));
  ASSERT_EQ(run("generate", functions + scratch.path("b")).code, 0);
  const auto body = [this](const char* folder) {
    const std::string text = scratch.read(std::string(folder) + "/arm.hpp");
    const std::size_t begin = text.find("inline void inverse_dynamics");
    return text.substr(begin, text.find("}  // namespace arm") - begin);
  };
  EXPECT_EQ(body("a"), body("b"));
}

// The effort limits are those of the torques with the springs', which are most of them here.
TEST_F(SpringsOfARobot, CountInTheTorquesOfExcitingMotions) {
  std::string text = arm(true);
  text.replace(text.find("upper = 1, velocity = 1, acceleration = 1, effort = 90"), 54,
               "upper = 1, velocity = 1, acceleration = 1, effort = 60");
  scratch.write("arm.toml", text);
  ASSERT_EQ(run("excite", "-q --duration 5 --evaluations 100 -o " + scratch.path("")).code, 0);
  const Outcome outcome = run(
      "torques", "--json --trajectory " + scratch.path("arm_excitation.csv") + " -o " + scratch.path("torques.csv"));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json rail = json::parse(outcome.out)["joints"][1];
  EXPECT_LE(std::abs(rail["torque"].get<double>()), 60) << rail;
  EXPECT_GE(std::abs(rail["torque"].get<double>()), 30) << rail;
}

// A log with a payload: the torques of the springs are those of the robot file.
TEST_F(SpringsOfARobot, AreNoPartOfPayloads) {
  scratch.write("loaded.toml", arm(true) + "[payload]\nmass = 1.5\ncom = [0.1, 0, 0]\n");
  const std::string robot = scratch.path("arm.toml"), log = scratch.path("log.csv");
  ASSERT_EQ(run("excite", "-q --duration 8 --evaluations 50 -o " + scratch.path("")).code, 0);
  ASSERT_EQ(run_flatdyn(fmt::format("torques {} -q --trajectory {} -o {}", scratch.path("loaded.toml"),
                                    scratch.path("arm_excitation.csv"), log))
                .code,
            0);
  const Outcome outcome = run_flatdyn(fmt::format("payload {} -q --json --data {}", robot, log));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NEAR(json::parse(outcome.out)["parameters"][0]["value"].get<double>(), 1.5, 1e-6) << outcome.out;
}

// A log of the robot with springs, and the same robot without them: what is estimated is written, and moves alike.
TEST_F(SpringsOfARobot, AreIdentifiedOnRequest) {
  scratch.write("plain.toml", arm(false));
  const auto flatdyn = [](const std::string& command) {
    const Outcome outcome = run_flatdyn(command);
    EXPECT_EQ(outcome.code, 0) << command << "\n" << outcome.err;
    return outcome;
  };
  const std::string plain = scratch.path("plain.toml"), log = scratch.path("log.csv"),
                    found = scratch.path("found.toml");
  flatdyn(fmt::format("excite {} -q --duration 8 --evaluations 50 -o {}", plain, scratch.path("")));
  flatdyn(fmt::format("torques {} -q --trajectory {} -o {}", scratch.path("arm.toml"),
                      scratch.path("arm_excitation.csv"), log));
  const Outcome outcome = flatdyn(fmt::format("identify {} -q --json --springs --data {} -o {}", plain, log, found));
  for (const json& each : json::parse(outcome.out)["further_parameters"]) {
    const std::map<std::string, double> wanted = {{"k1", 12}, {"kq1", 3.6}, {"k2", 200}, {"kq2", 0}};
    EXPECT_NEAR(each["value"], wanted.at(each["name"]), 1e-6) << each;
  }
  const std::string inspected = flatdyn("inspect " + found).out;
  EXPECT_THAT(inspected, HasSubstr("spring k = 12"));
  EXPECT_THAT(inspected, HasSubstr("spring k = 200"));
}

TEST_F(SpringsOfARobot, HaveARegressorOfTheirOwn) {
  const Outcome outcome = run("verify -q --json --states 4 --functions spring_regressor");
  ASSERT_EQ(outcome.code, 0) << outcome.err << outcome.out;
  EXPECT_TRUE(json::parse(outcome.out)["functions"][0]["proven"]);
  for (const char* robot : {"five_bar.toml", "finger.toml", "quadruped12.urdf --base floating"}) {
    const Outcome other = run_flatdyn(fmt::format(
        "verify {}/robots/{} -q --json --states 2 --functions spring_regressor", FLATDYN_SOURCE_DIR, robot));
    ASSERT_EQ(other.code, 0) << robot << other.err << other.out;
    EXPECT_TRUE(json::parse(other.out)["functions"][0]["proven"]) << robot;
  }
}

TEST_F(SpringsOfARobot, AreCertified) {
  const Outcome outcome = run("certify -q --functions inverse_dynamics --states 1000 --time-limit 0");
  EXPECT_EQ(outcome.code, 0) << outcome.err << outcome.out;
}

}  // namespace
}  // namespace flatdyn::testing
