// SPDX-License-Identifier: GPL-2.0-or-later
// The files and options of flatdyn identify, payload and excite: inputs are kept, and nothing is ignored silently.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include <nlohmann/json.hpp>

#include "cli/program.hpp"
#include "support/robot_models.hpp"
#include "support/simulated_log.hpp"

namespace flatdyn::testing {
namespace {

using nlohmann::json;
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

constexpr const char* kArmOfCurrents = "robots/planar_2r_example_7_2.toml";
constexpr const char* kJointsOfCurrents[] = {"theta_1", "theta_2"};

// A motion of the planar arm, and the same log with its torques named as currents.
class Drive : public ::testing::Test {
 protected:
  void SetUp() override {
    const Outcome outcome = run_flatdyn(
        fmt::format("excite {} -o {} --controller ros --evaluations 20 --duration 6", kArmOfCurrents, scratch.path()));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    std::string text = scratch.read("planar_2r_example_7_2_excitation.csv");
    const std::string heading = text.substr(0, text.find('\n'));
    EXPECT_EQ(heading, "t,q1,q2,qd1,qd2,qdd1,qdd2,tau1,tau2");
    text.replace(0, heading.size(), "t,q1,q2,qd1,qd2,qdd1,qdd2,tau1 [A],tau2 [A]");
    scratch.write("currents.csv", text);
  }

  Scratch scratch;
};

TEST_F(Drive, CurrentsNeedTheGainsOfTheDrives) {
  const std::string command = fmt::format("identify {} --data {}", kArmOfCurrents, scratch.path("currents.csv"));
  const Outcome without = run_flatdyn(command);
  EXPECT_NE(without.code, 0);
  EXPECT_THAT(without.err, HasSubstr("column \"tau1\" is a current, but the robot has no gain of the drive of joint "
                                     "\"theta_1\""));
  scratch.write("gains.toml", "[current_to_torque]\ntheta_1 = 2\ntheta_2 = -0.5\n");
  const Outcome found = run_flatdyn(command + " --json --scene " + scratch.path("gains.toml"));
  ASSERT_EQ(found.code, 0) << found.err;
  const json fitted = json::parse(found.out),
             plain = json::parse(run_flatdyn(fmt::format("identify {} --json --data {}", kArmOfCurrents,
                                                         scratch.path("planar_2r_example_7_2_excitation.csv")))
                                     .out);
  const double factors[] = {2, 0.5};
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(fitted["joints"][i]["name"], kJointsOfCurrents[i]);
    const double torque = fitted["joints"][i]["rms_torque"], as_written = plain["joints"][i]["rms_torque"];
    EXPECT_NEAR(torque, factors[i] * as_written, 1e-9 * torque);
  }
  scratch.write("zero.toml", "[current_to_torque]\ntheta_1 = 0\n");
  EXPECT_THAT(run_flatdyn(command + " --scene " + scratch.path("zero.toml")).err,
              HasSubstr("a drive's gain is a number but 0"));
}

TEST_F(Drive, ResultsAreAPythonModule) {
  const Outcome outcome =
      run_flatdyn(fmt::format("identify {} --data {} --module {}", kArmOfCurrents,
                              scratch.path("planar_2r_example_7_2_excitation.csv"), scratch.path("found.py")));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::string check =
      "import found as f; n = len(f.NAMES); assert n > 4 and f.NAMES[0] == 'm1lx'; "
      "assert all(len(x) == n for x in (f.VALUES, f.STANDARD_DEVIATIONS, f.FILE_VALUES, f.COMBINATIONS, "
      "f.COVARIANCE)); "
      "assert all(len(row) == n for row in f.COVARIANCE); assert abs(f.VALUES[0] - f.FILE_VALUES[0]) < 1e-6";
  EXPECT_EQ(std::system(fmt::format("cd {} && python3 -c \"{}\"", scratch.path(), check).c_str()), 0)
      << scratch.read("found.py");
}

TEST_F(Drive, MotionsAreForControllers) {
  const json trajectory = json::parse(scratch.read("planar_2r_example_7_2_excitation_trajectory.json"));
  EXPECT_EQ(trajectory["joint_names"], json(kJointsOfCurrents));
  ASSERT_EQ(trajectory["points"].size(), 601U);
  const json& last = trajectory["points"].back();
  EXPECT_EQ(last["time_from_start"], json({{"sec", 6}, {"nanosec", 0}}));
  for (const char* key : {"positions", "velocities", "accelerations"}) EXPECT_EQ(last[key].size(), 2U) << key;
  EXPECT_NEAR(last["velocities"][0], 0, 1e-9);
  const Outcome six = run_flatdyn(fmt::format("excite {} -o {} --controller ur", kArmOfCurrents, scratch.path()));
  EXPECT_NE(six.code, 0);
  EXPECT_THAT(six.err, HasSubstr("--controller ur is for robots with a fixed base and 6 joints"));
  const Outcome ur =
      run_flatdyn(fmt::format("excite robots/ur5.urdf -o {} --controller ur --evaluations 10 "
                              "--duration 2",
                              scratch.path()));
  ASSERT_EQ(ur.code, 0) << ur.err;
  const std::string script = scratch.read("ur5_excitation.script");
  std::size_t count = 0;
  for (std::size_t at = script.find("  servoj(["); at != std::string::npos; at = script.find("  servoj([", at + 1))
    ++count;
  EXPECT_EQ(count, 1000U);  // at 500 Hz
  EXPECT_THAT(script, HasSubstr(", 0, 0, 0.002, 0.1, 300)\n  stopj(1.0)\nend\nexcitation()\n"));
}

}  // namespace
}  // namespace flatdyn::testing
