// SPDX-License-Identifier: GPL-2.0-or-later
// Exit codes as in docs/exit-codes.md, and that nothing is written after an error.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <filesystem>

#include "cli/program.hpp"

namespace flatdyn::testing {
namespace {

using ::testing::HasSubstr;

constexpr const char* kPendulum = "robots/pendulum_motor.toml";

TEST(ExitCodes, WrongCommandLinesAreUsage) {
  for (const char* arguments :
       {"", "frobnicate", "generate", "generate robots/scara.toml", "inspect a.urdf b.urdf",
        "generate robots/scara.toml -o /tmp --scalar half", "verify robots/scara.toml --states 0",
        "inspect robots/scara.toml --gravity 1,2", "inspect robots/scara.toml --snap small",
        "inspect robots/scara.toml -Wall", "eval robots/scara.toml --function gravity"}) {
    const Outcome outcome = run_flatdyn(arguments);
    EXPECT_EQ(outcome.code, 2) << arguments;
    EXPECT_FALSE(outcome.err.empty()) << arguments;
    EXPECT_EQ(outcome.out, "") << arguments;
  }
}

TEST(ExitCodes, AnUnknownFunctionIsUsageAndNamesTheNearest) {
  const Scratch scratch;
  const Outcome near = run_flatdyn("generate robots/scara.toml -o " + scratch.path("out") + " --functions gravty");
  EXPECT_EQ(near.code, 2);
  EXPECT_THAT(near.err, HasSubstr("did you mean \"gravity\"?"));
  const Outcome far = run_flatdyn("generate robots/scara.toml -o " + scratch.path("out") + " --functions all");
  EXPECT_EQ(far.code, 2);
  EXPECT_THAT(far.err, HasSubstr("known functions: inverse_dynamics, "));
  const Outcome link =
      run_flatdyn("generate robots/scara.toml -o " + scratch.path("out") + " --functions jacobian:tool");
  EXPECT_EQ(link.code, 2);
  EXPECT_THAT(link.err, HasSubstr("link1, link2"));
  const Outcome twice = run_flatdyn("generate robots/scara.toml -o " + scratch.path("out") + " --functions bias,bias");
  EXPECT_EQ(twice.code, 2);
  EXPECT_TRUE(scratch.is_empty());
}

TEST(ExitCodes, AWrongFileIsInput) {
  const Scratch scratch;
  scratch.write("broken.urdf", "<robot name=\"a\">\n  <link name=\"b\">\n</robot>\n");
  const Outcome outcome = run_flatdyn("generate " + scratch.path("broken.urdf") + " -o " + scratch.path("out"));
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("broken.urdf:"));
  EXPECT_FALSE(std::filesystem::exists(scratch.path("out")));
}

// These features do not support closed loops yet.
TEST(ExitCodes, ClosedLoopsAreRefusedWhereTheyAreNotSupported) {
  const Scratch scratch;
  const std::string robot = "robots/slider_crank.toml", out = scratch.path("out");
  for (const std::string& command :
       {"derive " + robot, "certify " + robot, "report " + robot + " -o " + out, "excite " + robot + " -o " + out,
        "bench " + robot, "generate " + robot + " -o " + out + " --functions step:rk4"}) {
    const Outcome outcome = run_flatdyn(command);
    EXPECT_EQ(outcome.code, 4) << command << "\n" << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("closed loops")) << command;
    EXPECT_FALSE(std::filesystem::exists(out)) << command;
  }
}

TEST(ExitCodes, LoopFunctionsAreOfRobotsWithLoops) {
  const Scratch scratch;
  const Outcome outcome =
      run_flatdyn("generate robots/planar_2r.toml -o " + scratch.path("out") + " --functions loop_closure");
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.err, HasSubstr("no loops that have to be closed"));
}

constexpr const char* kTooFlat =
    "<robot name='a'><link name='b'/><link name='c'><inertial><mass value='1'/>"
    "<inertia ixx='1' iyy='1' izz='3' ixy='0' ixz='0' iyz='0'/></inertial></link>"
    "<joint name='j' type='revolute'><parent link='b'/><child link='c'/><axis xyz='0 0 1'/>"
    "<limit lower='-1' upper='1' effort='1' velocity='1'/></joint></robot>\n";

TEST(ExitCodes, AWarningIsInputUnderWerrorOnly) {
  const Scratch scratch;
  scratch.write("flat.urdf", kTooFlat);
  const Outcome plain = run_flatdyn("inspect " + scratch.path("flat.urdf"));
  EXPECT_EQ(plain.code, 0);
  EXPECT_THAT(plain.err, HasSubstr("warning: "));
  const Outcome strict = run_flatdyn("inspect -Werror " + scratch.path("flat.urdf"));
  EXPECT_EQ(strict.code, 3);
  EXPECT_THAT(strict.err, HasSubstr("warnings are errors (-Werror)"));
  EXPECT_EQ(strict.out, "");
}

TEST(ExitCodes, AJointThatCannotBeDoneYetIsUnsupported) {
  const Scratch scratch;
  scratch.write("base.urdf",
                "<robot name='a'><link name='b'/><link name='c'/>\n"
                "<joint name='j' type='universal'><parent link='b'/><child link='c'/></joint></robot>\n");
  const Outcome outcome = run_flatdyn("generate " + scratch.path("base.urdf") + " -o " + scratch.path("out"));
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.err, HasSubstr("base.urdf:2:"));
  EXPECT_FALSE(std::filesystem::exists(scratch.path("out")));
}

// No scaled error is below so small a bound unless the result is exact.
TEST(ExitCodes, AFailedVerificationSaysSo) {
  const Outcome outcome = run_flatdyn("verify robots/puma560.toml --functions gravity --states 20 --bound 1e-9");
  EXPECT_EQ(outcome.code, 5);
  EXPECT_THAT(outcome.out, HasSubstr("FAILED"));
  EXPECT_EQ(run_flatdyn("verify robots/puma560.toml --functions gravity --states 20").code, 0);
}

TEST(ExitCodes, WhatCannotBeReadOrWrittenIsIo) {
  const Scratch scratch;
  EXPECT_EQ(run_flatdyn("inspect " + scratch.path("nothing.urdf")).code, 6);
  EXPECT_EQ(run_flatdyn("inspect " + scratch.path()).code, 6);
  scratch.write("file", "");
  EXPECT_EQ(run_flatdyn(std::string("generate ") + kPendulum + " -o " + scratch.path("file")).code, 6);
  EXPECT_EQ(
      run_flatdyn(std::string("eval ") + kPendulum + " --function gravity --states " + scratch.path("none.csv")).code,
      6);
}

TEST(ExitCodes, NonsenseOnTheCommandLineIsUsage) {
  for (const char* arguments :
       {"inspect robots/scara.toml --snap -1", "inspect robots/scara.toml --snap 1",
        "inspect robots/scara.toml --gravity 0,0,0,", "inspect robots/scara.toml --gravity 0,0,1e-400",
        "inspect robots/scara.toml --tip nobody", "inspect robots/scara.toml --fix nobody",
        "verify robots/scara.toml --bound -1", "generate robots/scara.toml -o out --max-lines 29",
        "derive robots/scara.toml --max-terms -1", "generate robots/scara.toml -o ''",
        "generate robots/scara.toml -o /tmp --namespace sin"}) {
    const Outcome outcome = run_flatdyn(arguments);
    EXPECT_EQ(outcome.code, 2) << arguments << ": " << outcome.err;
    EXPECT_EQ(outcome.out, "") << arguments;
  }
  EXPECT_THAT(run_flatdyn("inspcet robots/scara.toml").err, HasSubstr("did you mean \"inspect\"?"));
}

TEST(ExitCodes, ALostStandardOutputIsInputOutput) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  const std::string command = std::string("cd " FLATDYN_SOURCE_DIR " && " FLATDYN_PROGRAM " inspect ") + kPendulum +
                              " > /dev/full 2> /dev/null";
  const int status = std::system(command.c_str());
  EXPECT_EQ(WEXITSTATUS(status), 6);
}

// A compiler that finds no room for its files says so; what it is given is not at fault.
TEST(ExitCodes, AFullTemporaryFolderIsInputOutput) {
  const Scratch scratch;
  scratch.write("compiler",
                "#!/bin/sh\n[ \"$1\" = --version ] && exit\n"
                "echo 'cc1plus: fatal error: error writing to x.s: No space left on device' >&2\nexit 1\n");
  std::filesystem::permissions(scratch.path("compiler"), std::filesystem::perms::owner_all);
  ASSERT_EQ(::setenv("CXX", scratch.path("compiler").c_str(), 1), 0);
  const Outcome outcome = run_flatdyn(std::string("verify ") + kPendulum + " --functions gravity -q");
  ASSERT_EQ(::unsetenv("CXX"), 0);
  EXPECT_EQ(outcome.code, 6) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("there is no room for temporary files"));
  EXPECT_THAT(outcome.err, HasSubstr("TMPDIR"));
}

// The same with a real folder of some kilobytes: whichever file is the first without room.
TEST(ExitCodes, ATooSmallTemporaryFolderIsInputOutput) {
  for (const char* size : {"16k", "24k", "32k", "48k"}) {
    const Scratch scratch;
    const std::string command = std::string("unshare -rm sh -c 'mount -t tmpfs -o size=") + size + " none " +
                                scratch.path() + " || exit 77; cd " FLATDYN_SOURCE_DIR "; TMPDIR=" + scratch.path() +
                                " " FLATDYN_PROGRAM " verify " + kPendulum +
                                " --functions gravity -q > /dev/null 2>&1'";
    const int status = WEXITSTATUS(std::system(command.c_str()));
    if (status == 77 || status == 1) GTEST_SKIP() << "no file system can be mounted here";
    EXPECT_EQ(status, 6) << size;
  }
}

TEST(OutputFiles, ALinkStaysALinkAndAFolderStopsBothFiles) {
  const Scratch scratch;
  const std::string generate = "generate robots/scara.toml -q --functions gravity -o ";
  scratch.write("target.hpp", "old");
  std::filesystem::create_symlink(scratch.path("target.hpp"), scratch.path("scara.hpp"));
  ASSERT_EQ(run_flatdyn(generate + scratch.path()).code, 0);
  EXPECT_TRUE(std::filesystem::is_symlink(scratch.path("scara.hpp")));
  EXPECT_THAT(scratch.read("target.hpp"), HasSubstr("namespace scara"));

  std::filesystem::create_directories(scratch.path("blocked/scara.json"));
  EXPECT_EQ(run_flatdyn(generate + scratch.path("blocked")).code, 6);
  EXPECT_FALSE(std::filesystem::exists(scratch.path("blocked/scara.hpp")));
}

TEST(OutputFiles, ARobotCalledLikeAFunctionOfCmathCompiles) {
  const Scratch scratch;
  scratch.write("gamma.toml", std::string("robot = \"" FLATDYN_SOURCE_DIR "/robots/scara.toml\"\nname = \"gamma\"\n"));
  ASSERT_EQ(run_flatdyn("generate -q --functions gravity " + scratch.path("gamma.toml") + " -o " + scratch.path()).code,
            0);
  EXPECT_EQ(std::system(("g++ -std=c++17 -fsyntax-only -x c++ " + scratch.path("gamma.hpp")).c_str()), 0);
}

}  // namespace
}  // namespace flatdyn::testing
