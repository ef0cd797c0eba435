// SPDX-License-Identifier: GPL-2.0-or-later
// The files and options of flatdyn identify, payload and excite: inputs are kept, and nothing is ignored silently.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/program.hpp"
#include "support/robot_models.hpp"
#include "support/simulated_log.hpp"

namespace flatdyn::testing {
namespace {

using ::testing::HasSubstr;

class IdentifyFiles : public ::testing::Test {
 protected:
  Scratch scratch;
  std::string arm = FLATDYN_SOURCE_DIR "/robots/planar_2r_example_7_2.toml";

  void SetUp() override {
    write_log(scratch.path("n.csv"), simulated(model_of("planar_2r_example_7_2.toml"), {.samples = 50}));
    scratch.write("rob.toml", fmt::format("robot = \"{}\"\n", arm));
  }
  // Runs `arguments` with {0} replaced by the scratch folder.
  Outcome run(const std::string& arguments) const {
    return run_flatdyn(fmt::format(fmt::runtime(arguments), scratch.path()));
  }
  void expect(const std::string& arguments, int code, const std::string& message) const {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, code) << arguments << "\n" << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(message)) << arguments;
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_LT(outcome.err.size(), 1000u) << arguments;
  }
};

TEST_F(IdentifyFiles, NumbersThatAreNoneAreUsage) {
  for (const std::string option :
       {"--band nan", "--band inf", "--band 0", "--band -1", "--band x", "--decimate 0", "--decimate nan",
        "--decimate 1.5", "--decimate -2", "--damping nan", "--damping 2"}) {
    expect("identify {0}/rob.toml --data {0}/n.csv " + option, 2, option.substr(0, option.find(' ')));
  }
  expect("identify {0}/rob.toml --data {0}/n.csv --band -1", 2, "must be a number greater than 0");
  for (const std::string option : {"--margin nan", "--duration nan", "--rate nan", "--rate inf", "--time nan"}) {
    expect("excite {0}/rob.toml --evaluations 60 -o {0}/out " + option, 2, "must be a number from ");
  }
  expect("verify {0}/rob.toml --bound nan", 2, "must be a number greater than 0");
  EXPECT_FALSE(std::filesystem::exists(scratch.path("out")));
}

TEST_F(IdentifyFiles, InputsAreNotReplaced) {
  std::filesystem::create_symlink(scratch.path("n.csv"), scratch.path("link.csv"));
  scratch.write("over.toml", "robot = \"rob.toml\"\n");
  scratch.write("part.json", "{}");
  const std::string robot = scratch.read("rob.toml"), log = scratch.read("n.csv");
  for (const std::string arguments :
       {"identify {0}/rob.toml --data {0}/n.csv -o {0}/rob.toml", "identify {0}/rob.toml --data {0}/n.csv -o {0}/n.csv",
        "identify {0}/rob.toml --data {0}/n.csv -o {0}/./link.csv",
        "identify {0}/rob.toml --data {0}/link.csv -o {0}/n.csv",
        "identify {0}/over.toml --data {0}/n.csv -o {0}/rob.toml",
        "identify {0}/rob.toml --data {0}/n.csv --part 1/2 -o {0}/n.csv",
        "identify {0}/rob.toml --merge {0}/part.json -o {0}/part.json",
        "payload {0}/rob.toml --data {0}/n.csv -o {0}/rob.toml", "payload {0}/rob.toml --data {0}/n.csv -o {0}/n.csv",
        "payload {0}/rob.toml --data {0}/n.csv --without {0}/link.csv -o {0}/link.csv"}) {
    expect(arguments, 2, "the output would replace the input");
  }
  EXPECT_EQ(scratch.read("rob.toml"), robot);
  EXPECT_EQ(scratch.read("n.csv"), log);
  expect("identify {0}/rob.toml --data {0}/n.csv -o {0}/x.svg --plot {0}/new/../x.svg", 2, "two outputs");
  EXPECT_FALSE(std::filesystem::exists(scratch.path("x.svg")));
  EXPECT_EQ(run("identify {0}/rob.toml -q --data {0}/n.csv -o /dev/null").code, 0);
}

TEST_F(IdentifyFiles, ExciteDoesNotReplaceTheRobot) {
  const std::string robot = scratch.read("rob.toml");
  std::filesystem::create_symlink(scratch.path("rob.toml"), scratch.path("arm_excitation.csv"));
  scratch.write("rob.toml", "name = \"arm\"\n" + robot);
  expect("excite {0}/rob.toml --evaluations 60 -o {0}", 2, "the output would replace the input");
  EXPECT_EQ(scratch.read("rob.toml"), "name = \"arm\"\n" + robot);
}

TEST_F(IdentifyFiles, WarningsAboutLogsAreErrorsIfTheyAreToBe) {
  std::string log = scratch.read("n.csv");
  for (std::size_t at = 0, line = 0; (at = log.find('\n', at)) != std::string::npos; at += 4, ++line) {
    log.insert(at, line == 0 ? ",q3" : ",0");
  }
  scratch.write("more.csv", log);
  for (const std::string command : {"identify", "payload"}) {
    const std::string arguments = command + " {0}/rob.toml -q --data {0}/more.csv -o {0}/out.toml";
    expect(arguments + " -Werror", 3, "warning: columns of joints that the robot does not have (it has 2)");
    EXPECT_FALSE(std::filesystem::exists(scratch.path("out.toml")));
    EXPECT_EQ(run(arguments).code, 0);
    EXPECT_TRUE(std::filesystem::remove(scratch.path("out.toml")));
  }
}

TEST_F(IdentifyFiles, OptionsWithoutEffectAreUsage) {
  for (const std::string arguments : {"--merge {0}/p.json --band 5", "--merge {0}/p.json --decimate 2",
                                      "--data {0}/n.csv --part 1/2 -o {0}/p.json --sequential",
                                      "--data {0}/n.csv --part 1/2 -o {0}/p.json --plot {0}/x.svg"}) {
    expect("identify {0}/rob.toml " + arguments, 2, "have no effect with");
  }
  expect("identify {0}/rob.toml --data {0}/n.csv --part 1/65537 -o {0}/p.json", 2, "at most 65536 parts");
  expect("identify {0}/rob.toml --data {0}/n.csv --plot {0}/x.pdf", 2, "name must end in .svg or .png");
}

TEST_F(IdentifyFiles, ALogThatCanBeReadOnlyOnceIsRefused) {
  const Outcome outcome = run("identify {0}/rob.toml --data /dev/stdin < {0}/n.csv");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const std::string fifo = scratch.path("pipe.csv");
  ASSERT_EQ(std::system(fmt::format("mkfifo {0} && (timeout 5 cat {1} > {0} &)", fifo, scratch.path("n.csv")).c_str()),
            0);
  expect("identify {0}/rob.toml --data {0}/pipe.csv", 6, "it is no regular file");
}

TEST_F(IdentifyFiles, PayloadKeepsTheSettingsAndQuotesNames) {
  std::filesystem::create_directory(scratch.path("we\"ird"));
  std::filesystem::copy(arm, scratch.path("we\"ird/rob.toml"));
  const Outcome outcome = run("payload '{0}/we\"ird/rob.toml' -q --gravity 1,-2,3 --data {0}/n.csv -o {0}/loaded.toml");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(scratch.read("loaded.toml"), HasSubstr("gravity = [1,-2,3]\n"));
  const LoadedRobot loaded = load_robot(scratch.path("loaded.toml"), {});
  EXPECT_TRUE(loaded.robot.has_payload);
  EXPECT_EQ(loaded.mechanism.gravity[1], Number(-2));
}

// The decimal is snapped to pi/2, and the file says so.
TEST_F(IdentifyFiles, PayloadRepeatsTheScene) {
  const LoadedRobot before = load_robot(scratch.path("rob.toml"), {});
  const std::string joint = before.mechanism.bodies[0].joint;
  scratch.write("scene.toml", "gravity = \"off\"\n[locked]\n" + joint + " = 1.5707963\n");
  std::string log = "t,q1,tau1\n";
  for (int k = 0; k < 400; ++k) log += fmt::format("{},{},{}\n", 0.01 * k, std::sin(0.03 * k), std::cos(0.03 * k));
  scratch.write("one.csv", log);
  const Outcome outcome = run("payload {0}/rob.toml -q --scene {0}/scene.toml --data {0}/one.csv -o {0}/loaded.toml");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(scratch.read("loaded.toml"), HasSubstr("fixed = { \"" + joint + "\" = \"pi/2\" }\n"));
  const LoadedRobot loaded = load_robot(scratch.path("loaded.toml"), {});
  EXPECT_EQ(loaded.mechanism.size(), before.mechanism.size() - 1);
  EXPECT_TRUE(vanishes(loaded.mechanism.gravity[2]));
}

TEST_F(IdentifyFiles, AWristNeedsNoTorques) {
  std::string log = "t,q1,q2,fx,fy,fz,mx,my,mz\n";
  for (int k = 0; k < 400; ++k) {
    const double t = 0.01 * k;
    log += fmt::format("{},{},{},1,2,3,4,5,6\n", t, std::sin(3 * t), std::cos(2 * t));
  }
  scratch.write("wrist.csv", log);
  const Outcome outcome = run("payload {0}/rob.toml -q --json --wrist --data {0}/wrist.csv");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  expect("payload {0}/rob.toml --data {0}/wrist.csv", 3, "no column for the torques");
}

// Ten seconds between poses are not milliseconds: the robot stands still in them.
TEST_F(IdentifyFiles, AWristTakesPosesThatAreFarApart) {
  std::string log = "t,q0,q1,qd0,qd1,qdd0,qdd1,fx,fy,fz,mx,my,mz\n";
  for (int k = 0; k < 40; ++k) {
    log += fmt::format("{},{},{},0,0,0,0,1,2,3,4,5,6\n", 10 * k, std::sin(3 * k), std::cos(2 * k));
  }
  scratch.write("poses.csv", log);
  const Outcome outcome = run("payload {0}/rob.toml --wrist --data {0}/poses.csv");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("note: columns counted from 0: q0 to q1, qd0 to qd1, qdd0 to qdd1"));
  EXPECT_THAT(outcome.err, ::testing::Not(HasSubstr("s pass")));
}

}  // namespace
}  // namespace flatdyn::testing
