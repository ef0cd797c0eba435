// SPDX-License-Identifier: GPL-2.0-or-later
// The messages that a person reads first: mistakes on the command line, help, errors as JSON, robots through pipes.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/program.hpp"

namespace flatdyn::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

constexpr const char* kBadMass =
    "<robot name='a'><link name='b'/>\n<link name='c'><inertial><mass value='-1'/>\n"
    "<inertia ixx='1' iyy='1' izz='1'/></inertial></link>\n"
    "<joint name='j' type='continuous'><parent link='b'/><child link='c'/></joint></robot>\n";

std::string message(const std::string& arguments) {
  const Outcome outcome = run_flatdyn(arguments);
  EXPECT_EQ(outcome.code, 2) << arguments;
  return outcome.err;
}

TEST(Messages, MisspeltOptionsGetTheNearest) {
  EXPECT_EQ(message("generate robots/scara.toml --funtions gravity"),
            "flatdyn: error: flatdyn generate has no option --funtions\n    hint: did you mean \"--functions\"?\n");
  EXPECT_EQ(message("--verion"),
            "flatdyn: error: flatdyn has no option --verion\n    hint: did you mean \"--version\"?\n");
  EXPECT_THAT(message("inspect a.urdf b.urdf"), HasSubstr("\"b.urdf\" is more than it takes"));
  EXPECT_THAT(message("generate robots/scara.toml"), HasSubstr("flatdyn: error: --output is required\n    hint: "));
  EXPECT_THAT(message("simulate robots/scara.toml -o m.csv --method rk4 --tolerance 1e-6"),
              HasSubstr("--tolerance has no effect with --method rk4"));
}

TEST(Messages, WhatIsWrongOnTheCommandLineBeginsWithTheProgram) {
  EXPECT_EQ(message("inspect robots/ur5.urdf --fix elbow_join"),
            "flatdyn: error: there is no joint \"elbow_join\" to be fixed\n    hint: did you mean \"elbow_joint\"?\n");
  EXPECT_THAT(message("inspect robots/ur5.urdf --tip tool1"), HasSubstr("flatdyn: error: --tip: there is no link"));
  EXPECT_THAT(message("eval robots/scara.toml --function gravity --function bias --states q.csv -o x.csv"),
              HasSubstr("flatdyn: error: --function is given 2 times\n    hint: give it once"));
}

TEST(Messages, ANameMayBeTooLongForAFile) {
  const Scratch scratch;
  std::string text = kBadMass;
  text.replace(text.find("'a'") + 1, 1, std::string(300, 'a'));
  text.replace(text.find("-1"), 2, "1");
  scratch.write("r.urdf", text);
  const std::string command =
      "generate -q --functions gravity " + scratch.path("r.urdf") + " -o " + scratch.path("out");
  const Outcome outcome = run_flatdyn(command);
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err,
              HasSubstr("is too long for a file\n    hint: generated files are called as the robot; --name"));
  EXPECT_EQ(run_flatdyn(command + " --name r").code, 0);
}

TEST(Messages, InputsAreCountedAsJointsAre) {
  const Scratch scratch;
  const Outcome outcome = run_flatdyn("generate robots/ur5.urdf --functions gravity -o " + scratch.path());
  EXPECT_THAT(outcome.out, HasSubstr("q_2 to q_5"));
}

TEST(Messages, ListsOfNamesMayHaveBlanksAndNoHoles) {
  const std::string command = "verify robots/scara.toml --states 2 --json --functions ";
  const json report = json::parse(run_flatdyn(command + "'gravity, bias'").out);
  EXPECT_EQ(report["functions"].size(), 2U);
  EXPECT_THAT(message(command + "gravity,,bias"), HasSubstr("no name behind \"gravity,\""));
}

TEST(Messages, HelpIsNotWiderThanATerminal) {
  for (const char* command : {"",         "generate", "inspect", "derive", "verify",   "eval",           "excite",
                              "identify", "payload",  "torques", "scale",  "simulate", "manipulability", "report",
                              "bench",    "certify",  "stress",  "help",   "man",      "completion"}) {
    std::istringstream lines(run_flatdyn(fmt::format("{} --help", command)).out);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 120U) << command << ": " << line;
  }
}

TEST(Messages, ErrorsAreJsonWhereResultsAre) {
  const Scratch scratch;
  scratch.write("bad.urdf", kBadMass);
  const Outcome outcome = run_flatdyn("inspect --json " + scratch.path("bad.urdf"));
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("bad.urdf:2: error: "));
  const json object = json::parse(outcome.out);
  EXPECT_EQ(object["json_version"], 1);
  EXPECT_EQ(object["exit_code"], 3);
  ASSERT_EQ(object["errors"].size(), 1U);
  EXPECT_EQ(object["errors"][0]["severity"], "error");
  EXPECT_EQ(object["errors"][0]["line"], 2);
  EXPECT_THAT(object["errors"][0]["message"], HasSubstr("mass is negative"));
  EXPECT_TRUE(object["errors"][0].contains("hint"));

  const json usage = json::parse(run_flatdyn("inspect robots/scara.toml --json --jsn").out);
  EXPECT_EQ(usage["errors"][0]["hint"], "did you mean \"--json\"?");
}

TEST(Pipes, ARobotComesFromStdinAndAHeaderGoesToStdout) {
  const Scratch scratch;
  const std::string options = " -q --functions gravity -o ";
  ASSERT_EQ(run_flatdyn("generate robots/ur5.urdf" + options + scratch.path()).code, 0);
  for (const char* input : {"robots/ur5.urdf", "robots/scara.toml"}) {
    const Outcome outcome = run_flatdyn(fmt::format("generate -{}- < {}", options, input));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_THAT(outcome.out, HasSubstr("gravity(")) << input;
  }
  EXPECT_EQ(run_flatdyn("generate /dev/stdin" + options + "- < robots/ur5.urdf").out, scratch.read("ur5.hpp"));
  EXPECT_EQ(run_flatdyn("generate -" + options + "- < robots/ur5.urdf").out, scratch.read("ur5.hpp"));
  EXPECT_THAT(message("generate robots/ur5.urdf --language c -o -"), HasSubstr("stdout has room for one"));
  EXPECT_THAT(message("certify robots/ur5.urdf -o -"), HasSubstr("stdout has room for one"));
}

TEST(Interrupted, ExcitationWritesTheBestMotionSoFar) {
  const Scratch scratch;
  const std::string command = fmt::format(
      "timeout --signal=INT --preserve-status 3 '{}' excite '{}/robots/ur5.urdf' -q "
      "--evaluations 10000000 -o '{}' 2> '{}'; echo $? > '{}'",
      FLATDYN_PROGRAM, FLATDYN_SOURCE_DIR, scratch.path(), scratch.path("err"), scratch.path("code"));
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_EQ(scratch.read("code"), "130\n");
  EXPECT_THAT(scratch.read("err"), HasSubstr("flatdyn: error: interrupted"));
  EXPECT_FALSE(scratch.read("ur5_excitation.csv").empty());
}

TEST(Interrupted, ErrorsAreJsonWhereResultsAre) {
  const Scratch scratch;
  const std::string command = fmt::format(
      "env --default-signal=INT timeout --signal=INT --preserve-status 3 '{}' verify '{}/robots/panda.urdf' -q --json "
      "--states 1000000 > '{}'; echo $? > '{}'",
      FLATDYN_PROGRAM, FLATDYN_SOURCE_DIR, scratch.path("out"), scratch.path("code"));
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_EQ(scratch.read("code"), "130\n");
  const json object = json::parse(scratch.read("out"));
  EXPECT_EQ(object["exit_code"], 130);
  EXPECT_EQ(object["errors"].size(), 1U);
}

}  // namespace
}  // namespace flatdyn::testing
