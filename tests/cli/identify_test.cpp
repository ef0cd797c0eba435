// SPDX-License-Identifier: GPL-2.0-or-later
// flatdyn identify as a user runs it: a log as input, a robot file as output, spread over ranks, and the examples of
// docs/.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/program.hpp"
#include "support/parallel_filter.hpp"
#include "support/robot_models.hpp"
#include "support/simulated_log.hpp"

namespace flatdyn::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

constexpr const char* kPuma = "robots/puma560.toml";

std::vector<std::vector<double>> numbers_of(const std::string& csv) {
  std::vector<std::vector<double>> rows;
  std::istringstream lines(csv);
  std::string line, entry;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    rows.emplace_back();
    std::istringstream entries(line);
    while (std::getline(entries, entry, ',')) rows.back().push_back(std::stod(entry));
  }
  return rows;
}

// The torques of a robot file at the states of a log.
std::vector<std::vector<double>> torques(const std::string& robot, const std::string& log) {
  const Outcome outcome = run_flatdyn(fmt::format("eval {} -q --function inverse_dynamics --states {}", robot, log));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return numbers_of(outcome.out);
}

TEST(Identify, WritesARobotFileWhoseTorquesAreThoseMeasured) {
  const Scratch scratch;
  write_log(scratch.path("log.csv"), simulated(model_of("puma560.toml"), {.samples = 1500, .noise = 0.02}));
  const std::string output = scratch.path("identified.toml");
  const Outcome outcome =
      run_flatdyn(fmt::format("identify {} --data {} -o {} --sequential", kPuma, scratch.path("log.csv"), output));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  for (const char* text : {"1500 samples, 1500 used", "std dev", "joint by joint", "condition number", "wrote "}) {
    EXPECT_THAT(outcome.out, HasSubstr(text));
  }
  write_log(scratch.path("other.csv"), simulated(model_of("puma560.toml"), {.samples = 50, .seed = 9}));
  const auto truth = torques(kPuma, scratch.path("other.csv")), found = torques(output, scratch.path("other.csv"));
  ASSERT_EQ(truth.size(), 50u);
  ASSERT_EQ(found.size(), 50u);
  for (std::size_t k = 0; k < truth.size(); ++k) {
    for (std::size_t i = truth[k].size() - 6; i < truth[k].size(); ++i) EXPECT_NEAR(found[k][i], truth[k][i], 0.05);
  }
}

// A log is not judged by itself, and options that cannot have an effect are refused before logs are read.
TEST(Identify, RefusesOptionsWithoutAnEffect) {
  const Scratch scratch;
  scratch.write("log.csv", "t,q1,q2,tau1,tau2\n");
  const std::string log = scratch.path("log.csv"),
                    identify = "identify robots/planar_2r_example_7_2.toml --data " + log;
  for (const auto& [options, message] :
       {std::pair<std::string, const char*>{" --validate " + log, "that log is one of --data, too"},
        {" --parameters inertial --friction stribeck", "--friction has no effect with --parameters inertial"},
        {" --gravity off --gravity-direction", "the robot is without gravity"},
        {" --friction asymmetric --offsets", "--friction asymmetric and --offsets cannot be told apart"},
        {" --rest-speed nan", "must be a number from 0"},
        {" --rest-speed -1", "must be a number from 0"}}) {
    const Outcome outcome = run_flatdyn(identify + options);
    EXPECT_EQ(outcome.code, 2) << options << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(message)) << options;
  }
  const Outcome payload = run_flatdyn("payload robots/planar_2r_example_7_2.toml --data " + log + " --without " + log);
  EXPECT_EQ(payload.code, 2) << payload.err;
  EXPECT_THAT(payload.err, HasSubstr("that log is one of --data, too"));
}

// The robot has neither friction nor rotors, but the file has both. If only inertias are asked for, the robot written
// has neither.
// A user's way: a motion, the robot that makes it under a controller, and its log with positions and torques alone. At
// every change of direction the joints stick for a while.
TEST(Identify, FindsFrictionAndRotorsOfASimulatedRobot) {
  constexpr double kViscous = 2, kCoulomb = 2.5, kRotor = 0.35;  // of every joint
  const Scratch scratch;
  const std::string plain = fmt::format("{}/robots/ur5.urdf", FLATDYN_SOURCE_DIR);
  std::string text = fmt::format("robot = \"{}\"\n", plain);
  for (const char* joint : {"shoulder_pan", "shoulder_lift", "elbow", "wrist_1", "wrist_2", "wrist_3"}) {
    text += fmt::format("[[joint]]\nname = \"{}_joint\"\nviscous = {}\ncoulomb = {}\narmature = {}\n", joint, kViscous,
                        kCoulomb, kRotor);
  }
  scratch.write("real.toml", text);
  scratch.write("follow.toml",
                "duration = 20\nrate = 1000\n[torque.computed_torque]\nkp = 100\nkd = 20\n"
                "trajectory = \"ur5_excitation.csv\"\n");
  const std::string real = scratch.path("real.toml");
  const auto run = [](const std::string& command) {
    const Outcome outcome = run_flatdyn(command);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome;
  };
  run(fmt::format("excite {} -o {} --parameters full --evaluations 200 -q", real, scratch.path("")));
  run(fmt::format("simulate {} --simulation {} -o {} -q", real, scratch.path("follow.toml"), scratch.path("all.csv")));
  const std::string columns = "cut -d, -f1-7,20-25";
  ASSERT_EQ(
      std::system(fmt::format("{} '{}' > '{}'", columns, scratch.path("all.csv"), scratch.path("log.csv")).c_str()), 0);
  const Outcome found = run(fmt::format("identify {} -q --json --data {}", plain, scratch.path("log.csv")));
  int checked = 0;
  const json result = json::parse(found.out);
  for (const json& parameter : result["base_parameters"]) {
    const std::string kind = parameter["kept"].get<std::string>().substr(0, 2);
    const double truth = kind == "Fv" ? kViscous : kind == "Fs" ? kCoulomb : kind == "Im" ? kRotor : 0;
    if (truth == 0) continue;
    EXPECT_NEAR(parameter["value"], truth, 1e-3 * truth) << parameter["kept"];
    ++checked;
  }
  EXPECT_EQ(checked, 16);
}

TEST(Identify, LeavesFrictionAndRotorsOutWhereOnlyInertiasAreAskedFor) {
  const Scratch scratch;
  const std::string log = scratch.path("log.csv"), output = scratch.path("identified.toml");
  LoadedRobot bare = model_of("puma560.toml");
  for (Joint& joint : bare.robot.joints) {
    joint.viscous = joint.coulomb = joint.armature = Value{};
    joint.motor.reset();
  }
  const auto samples = simulated(bare, {.samples = 600, .noise = 0.01});
  write_log(log, samples);
  const Outcome outcome =
      run_flatdyn(fmt::format("identify {} -q --parameters inertial --data {} -o {}", kPuma, log, output));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto found = torques(output, log);
  ASSERT_EQ(found.size(), samples.size());
  for (std::size_t k = 0; k < samples.size(); ++k) {
    for (std::size_t i = 0; i < 6; ++i) {
      EXPECT_NEAR(found[k][found[k].size() - 6 + i], samples[k].tau(static_cast<Eigen::Index>(i)), 0.1);
    }
  }
}

// The log has torques in mN m.
TEST(Identify, SaysWhatIsBeyondAllSizes) {
  const Scratch scratch;
  auto samples = simulated(model_of("planar_2r_example_7_2.toml"), {.samples = 500});
  write_log(scratch.path("right.csv"), samples);
  for (SimulatedSample& sample : samples) sample.tau *= 1000;
  write_log(scratch.path("wrong.csv"), samples);
  const std::string command = "identify robots/planar_2r_example_7_2.toml -q -o " + scratch.path("found.toml");
  const Outcome right = run_flatdyn(command + " --data " + scratch.path("right.csv"));
  ASSERT_EQ(right.code, 0) << right.err;
  EXPECT_EQ(right.err, "");
  const Outcome strict = run_flatdyn(command + " -Werror --data " + scratch.path("wrong.csv"));
  EXPECT_EQ(strict.code, 3);
  const Outcome wrong = run_flatdyn(command + " --data " + scratch.path("wrong.csv"));
  ASSERT_EQ(wrong.code, 0) << wrong.err;
  for (const std::string& text : {wrong.err, strict.err, scratch.read("found.toml")}) {
    EXPECT_THAT(text, HasSubstr("I1zz"));
    EXPECT_THAT(text, HasSubstr("more than 100 times all that the robot file has, which can hardly be right"));
  }
}

// The second joint's torque is a different signal: its weight becomes so small that no other check would notice.
TEST(Identify, SaysThatAJointIsNotExplained) {
  const Scratch scratch;
  auto samples = simulated(model_of("planar_2r_example_7_2.toml"), {.samples = 500});
  for (SimulatedSample& sample : samples) sample.tau(1) = 2000 * std::cos(300 * sample.time);
  write_log(scratch.path("log.csv"), samples);
  const Outcome outcome =
      run_flatdyn("identify robots/planar_2r_example_7_2.toml -q --json --data " + scratch.path("log.csv"));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("joint \"theta_2\": the model leaves"));
  EXPECT_THAT(json::parse(outcome.out)["doubts"].dump(), HasSubstr("theta_2"));
}

TEST(Identify, SaysThatGapsTakeMostSamples) {
  const Scratch scratch;
  auto samples = simulated(model_of("planar_2r_example_7_2.toml"), {.samples = 4000, .rate = 200});
  for (long k = 300; k + 4 < static_cast<long>(samples.size()); k += 300) {
    samples.erase(samples.begin() + k, samples.begin() + k + 4);
  }
  write_log(scratch.path("log.csv"), samples, LogDerivatives::none);
  const Outcome outcome =
      run_flatdyn("identify robots/planar_2r_example_7_2.toml -q --data " + scratch.path("log.csv"));
  EXPECT_THAT(outcome.err, HasSubstr("gaps in time take most of"));
}

TEST(Identify, SaysItInJsonToo) {
  const Scratch scratch;
  write_log(scratch.path("log.csv"), simulated(model_of("puma560.toml"), {.samples = 300}));
  const Outcome outcome = run_flatdyn(fmt::format("identify {} -q --json --data {}", kPuma, scratch.path("log.csv")));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json report = json::parse(outcome.out);
  EXPECT_EQ(report["samples"], 300);
  EXPECT_EQ(report["joints"].size(), 6u);
  EXPECT_TRUE(report["damped"].empty());
  for (const json& each : report["base_parameters"]) {
    EXPECT_NEAR(each["value"].get<double>(), each["file"].get<double>(),
                1e-9 * std::abs(each["file"].get<double>()) + 1e-12)
        << each["kept"];
  }
}

TEST(Identify, RefusesOptionsThatReadLogsAgainWithParts) {
  for (const char* option : {"--delay", "--gravity-direction"}) {
    const Outcome outcome =
        run_flatdyn(fmt::format("identify {} {} --data log.csv --part 1/2 -o part.json", kPuma, option));
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("read the logs more than once"));
  }
}

TEST(Identify, RefusesWhatItCannotUse) {
  const Scratch scratch;
  write_log(scratch.path("log.csv"), simulated(model_of("planar_2r_example_7_2.toml"), {.samples = 50}));
  const std::string log = scratch.path("log.csv");
  const std::tuple<std::string, int, const char*> cases[] = {
      {"identify robots/planar_2r_example_7_2.toml", 2, "identify needs --data LOG.csv, or --merge PART..."},
      {"identify robots/planar_2r_example_7_2.toml --part 5/4 -o x --data " + log, 2, "write k/N with 1 <= k <= N"},
      {"identify robots/planar_2r_example_7_2.toml --part 1/4 --data " + log, 2,
       "--part needs --data LOG.csv and -o FILE"},
      {"identify robots/planar_2r.toml --data " + log, 4, "the robot has free symbols"},
      {"identify robots/puma560.toml --data " + log, 3, "log.csv:1: error: no column for the positions: q3"},
      {"identify robots/planar_2r_example_7_2.toml --data /nowhere.csv", 6, "/nowhere.csv: cannot be read"},
      {"identify robots/planar_2r_example_7_2.toml --merge '/nowhere/part*.json'", 6, "no file has such a name"},
  };
  for (const auto& [arguments, code, message] : cases) {
    const Outcome outcome = run_flatdyn(arguments);
    EXPECT_EQ(outcome.code, code) << arguments;
    EXPECT_THAT(outcome.err, HasSubstr(message)) << arguments;
    EXPECT_EQ(outcome.out, "") << arguments;
  }
}

TEST(Payload, ComesOutAsARobotFile) {
  const Scratch scratch;
  scratch.write("truth.toml", fmt::format("robot = \"{}/robots/puma560.toml\"\n[payload]\nmass = 2.5\ncom = [0.05, 0, "
                                          "0.1]\ninertia = {{ xx = 0.01, yy = 0.02, zz = 0.015 }}\ninertia_about = "
                                          "\"com\"\n",
                                          FLATDYN_SOURCE_DIR));
  const LoadedRobot loaded = load_robot(scratch.path("truth.toml"), {});
  write_log(scratch.path("with.csv"), simulated(loaded, {.samples = 800, .noise = 0.01}));
  write_log(scratch.path("without.csv"),
            simulated(model_of("puma560.toml"), {.samples = 800, .noise = 0.01, .seed = 4}));
  const Outcome outcome =
      run_flatdyn(fmt::format("payload {} -q --json --data {} --without {} -o {}", kPuma, scratch.path("with.csv"),
                              scratch.path("without.csv"), scratch.path("loaded.toml")));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json mass = json::parse(outcome.out)["parameters"][0];
  EXPECT_EQ(mass["name"], "m");
  EXPECT_EQ(mass["unit"], "kg");
  EXPECT_NEAR(mass["value"].get<double>(), 2.5, 0.02);
  write_log(scratch.path("other.csv"), simulated(loaded, {.samples = 20, .seed = 9}));
  const auto truth = torques(scratch.path("truth.toml"), scratch.path("other.csv"));
  const auto found = torques(scratch.path("loaded.toml"), scratch.path("other.csv"));
  for (std::size_t k = 0; k < truth.size(); ++k) {
    for (std::size_t i = truth[k].size() - 6; i < truth[k].size(); ++i) EXPECT_NEAR(found[k][i], truth[k][i], 0.1);
  }
}

// The mass comes out negative, which is impossible.
TEST(Payload, SaysThatLogsMayBeExchanged) {
  const Scratch scratch;
  scratch.write("truth.toml", fmt::format("robot = \"{}/robots/puma560.toml\"\n[payload]\nmass = 1.5\n"
                                          "com = [0, 0, 0.1]\ninertia = {{ xx = 0.01, yy = 0.01, zz = 0.01 }}\n"
                                          "inertia_about = \"com\"\n",
                                          FLATDYN_SOURCE_DIR));
  write_log(scratch.path("with.csv"),
            simulated(load_robot(scratch.path("truth.toml"), {}), {.samples = 400, .noise = 0.01}));
  write_log(scratch.path("without.csv"),
            simulated(model_of("puma560.toml"), {.samples = 400, .noise = 0.01, .seed = 4}));
  const std::string command = fmt::format("payload {} -o {} --data ", kPuma, scratch.path("loaded.toml"));
  const std::string with = scratch.path("with.csv"), without = scratch.path("without.csv");
  const Outcome exchanged = run_flatdyn(command + without + " --without " + with);
  ASSERT_EQ(exchanged.code, 0) << exchanged.err;
  for (const std::string& text : {exchanged.err, scratch.read("loaded.toml")}) {
    EXPECT_THAT(text, HasSubstr("units or geometry cannot be right\n"));
    EXPECT_THAT(text, HasSubstr("the mass is negative: are --data and --without exchanged?\n"));
  }
  const Outcome right = run_flatdyn(command + with + " --without " + without);
  ASSERT_EQ(right.code, 0) << right.err;
  EXPECT_EQ(right.err, "");
  EXPECT_EQ(run_flatdyn(command + without + " -Werror --without " + with).code, 3);
}

TEST(Payload, NeedsASensorWhereItIsToldToUseOne) {
  const Scratch scratch;
  write_log(scratch.path("log.csv"), simulated(model_of("planar_2r_example_7_2.toml"), {.samples = 50}));
  const Outcome outcome =
      run_flatdyn("payload robots/planar_2r_example_7_2.toml --wrist --data " + scratch.path("log.csv"));
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("log.csv:1: error: no columns fx, fy, fz, mx, my, mz"));
}

TEST(Identify, SaysThatALogIsTooShortForTheFilter) {
  const Scratch scratch;
  write_log(scratch.path("log.csv"), simulated(model_of("puma560.toml"), {.samples = 50}), LogDerivatives::none);
  const Outcome outcome = run_flatdyn(fmt::format("identify {} -q --data {}", kPuma, scratch.path("log.csv")));
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("none of 50 samples can be used: the filter's window has 143 of them"));
}

// All axes are parallel, so that no torque depends on gravity along them.
TEST(Identify, SaysWhatOfGravityNothingTells) {
  const Scratch scratch;
  write_log(scratch.path("log.csv"), simulated(model_of("planar_2r_example_7_2.toml"), {.samples = 800, .noise = 2}));
  const Outcome outcome = run_flatdyn(
      "identify robots/planar_2r_example_7_2.toml -q --json --gravity-direction --data " + scratch.path("log.csv"));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err,
              HasSubstr("nothing in the log tells gravity's component along [0, 0, 1] in the base frame: it "
                        "keeps the robot file's value, 0 m/s^2"));
  const json gravity = json::parse(outcome.out)["gravity"];
  EXPECT_EQ(gravity["not_told"].size(), 1u);
  for (int d = 0; d < 2; ++d) {
    const double deviation = gravity["standard_deviation"][d], truth = d == 1 ? -9.81 : 0;
    EXPECT_NEAR(gravity["value"][d].get<double>(), truth, 4 * deviation + 1e-3);
  }
  EXPECT_GT(gravity["standard_deviation"][0], 1e-5);
  EXPECT_EQ(gravity["standard_deviation"][2], 0);
}

TEST(Identify, SaysWhyNoSampleCanBeUsed) {
  const Scratch scratch;
  const LoadedRobot robot = model_of("planar_2r_example_7_2.toml");
  std::vector<SimulatedSample> samples = simulated(robot, {.samples = 1000});
  write_log(scratch.path("motion.csv"), samples, LogDerivatives::none);
  for (SimulatedSample& sample : samples) sample.q = samples.front().q;
  write_log(scratch.path("held.csv"), samples, LogDerivatives::none);
  write_log(scratch.path("poses.csv"), simulated(robot, {.samples = 40, .rate = 0.5, .standing = true}),
            LogDerivatives::none);
  for (const auto& [arguments, message] :
       {std::pair{"motion.csv --decimate 100000", "none of 1000 samples can be used: --decimate 100000 leaves none"},
        {"held.csv --parameters full", "no joint moves in the log: at rest a joint's friction may be anything"},
        {"poses.csv", "poses that are held need columns qd1, ... and qdd1, ... of zeros"}}) {
    const Outcome outcome =
        run_flatdyn("identify robots/planar_2r_example_7_2.toml -q --data " + scratch.path("") + arguments);
    EXPECT_EQ(outcome.code, 3) << arguments << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(message)) << arguments;
  }
}

// Four ranks, each with a part of the log.
class MpiTest : public ::testing::Test {
 protected:
  Scratch scratch;

  void SetUp() override {
    if (std::system("mpirun --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "no mpirun";
    write_log(scratch.path("log.csv"),
              simulated(model_of("planar_2r_example_7_2.toml"), {.samples = 300000, .rate = 1000}));
  }

  // Runs the ranks; `limit` is a command that runs flatdyn under a limit.
  void run_ranks(const std::string& limit) {
    scratch.write("rank.sh", fmt::format("{} {} identify robots/planar_2r_example_7_2.toml -q --data {} -o "
                                         "{}$OMPI_COMM_WORLD_RANK.json --part $((OMPI_COMM_WORLD_RANK + 1))/4\n",
                                         limit, FLATDYN_PROGRAM, scratch.path("log.csv"), scratch.path("part")));
    const std::string command = fmt::format(
        "cd {} && OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 mpirun -n 4 --oversubscribe "
        "--enable-recovery sh {} > /dev/null 2>&1",
        FLATDYN_SOURCE_DIR, scratch.path("rank.sh"));
    [[maybe_unused]] const int status = std::system(command.c_str());
  }
  Outcome merged() {
    return run_flatdyn(
        fmt::format("identify robots/planar_2r_example_7_2.toml -q --json --merge {}*.json", scratch.path("part")));
  }
};

TEST_F(MpiTest, RanksTogetherFindWhatOneRunFinds) {
  run_ranks("");
  const Outcome together = merged();
  ASSERT_EQ(together.code, 0) << together.err;
  const Outcome alone =
      run_flatdyn("identify robots/planar_2r_example_7_2.toml -q --json --data " + scratch.path("log.csv"));
  ASSERT_EQ(alone.code, 0) << alone.err;
  const json a = json::parse(together.out), b = json::parse(alone.out);
  EXPECT_EQ(a["used"], b["used"]);
  for (std::size_t k = 0; k < b["base_parameters"].size(); ++k) {
    const double value = b["base_parameters"][k]["value"];
    EXPECT_NEAR(a["base_parameters"][k]["value"].get<double>(), value, 1e-10 * std::abs(value) + 1e-10);
  }
}

// The rank is killed while it compiles the regressor, which takes longest.
TEST_F(MpiTest, OfARankThatWasKilledThePartIsMissed) {
  run_ranks("exec $(if [ $OMPI_COMM_WORLD_RANK = 2 ]; then echo timeout -s KILL 0.2; fi)");
  const Outcome outcome = merged();
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("missing: part 3 of 4"));
  EXPECT_THAT(outcome.err, HasSubstr("make it again with --part 3/4"));
}

// Runs a script of docs/examples/ with a short search; more: further arguments; variables: such as "RATE=500".
Outcome run_example(const std::string& script, const std::string& folder, const std::string& more = "",
                    const std::string& variables = "") {
  const std::string command =
      fmt::format("cd {} && EVALUATIONS=60 FLATDYN={} {} docs/examples/{} {} {} > {}/out 2> {}/err", FLATDYN_SOURCE_DIR,
                  FLATDYN_PROGRAM, variables, script, folder, more, folder, folder);
  Outcome outcome;
  outcome.code = std::system(command.c_str());
  return outcome;
}

TEST(Examples, ThePlanarArmIsIdentifiedFromExample72sMotion) {
  const Scratch scratch;
  ASSERT_EQ(run_example("identify_planar_arm.sh", scratch.path()).code, 0) << scratch.read("err");
  EXPECT_THAT(scratch.read("out"), HasSubstr("2002 samples, 2002 used"));
  // Rows of docs/identification.md.
  for (const char* row : {"m1lx  79.9961      0.0063   0.0079 %   79.9936", "I1zz  177.513      0.0057   0.0032 %",
                          "Im2   0.0100002    5.2e-07  0.0052 %"}) {
    EXPECT_THAT(scratch.read("out"), HasSubstr(row));
  }
  EXPECT_THAT(scratch.read("residuals.svg"), HasSubstr("one log behind the other"));
  EXPECT_EQ(run_flatdyn("verify -q --states 5 --functions inverse_dynamics " + scratch.path("identified.toml")).code,
            0);
}

// All masses of the given robot file are wrong; the result must be right nevertheless.
TEST(Examples, APandaIsIdentifiedFromAnExcitationWithNoise) {
  const Scratch scratch;
  ASSERT_EQ(run_example("identify_panda.sh", scratch.path()).code, 0) << scratch.read("err");
  EXPECT_THAT(scratch.read("residuals.svg"), HasSubstr("<svg"));
  EXPECT_EQ(scratch.read("out").find("did not converge"), std::string::npos) << scratch.read("out");
  EXPECT_THAT(scratch.read("out"), HasSubstr("divergence from the file's links: "));
  write_log(scratch.path("other.csv"), simulated(model_of("panda.urdf"), {.samples = 50, .seed = 9}));
  const auto truth = torques("robots/panda.urdf", scratch.path("other.csv"));
  const auto found = torques(scratch.path("identified.toml"), scratch.path("other.csv"));
  const auto wrong = torques(scratch.path("panda_unknown.urdf"), scratch.path("other.csv"));
  double largest = 0, largest_before = 0;
  for (std::size_t k = 0; k < truth.size(); ++k) {
    for (std::size_t i = truth[k].size() - 7; i < truth[k].size(); ++i) {
      largest = std::max(largest, std::abs(found[k][i] - truth[k][i]));
      largest_before = std::max(largest_before, std::abs(wrong[k][i] - truth[k][i]));
    }
  }
  EXPECT_LT(largest, 0.3);
  EXPECT_GT(largest_before, 5);
}

// A log with all that a model lacks, judged by a second one.
struct PracticalCase {
  const char* robot;
  int rate;         // samples a second
  int evaluations;  // of the search for the motion
};

class PracticalExample : public ::testing::TestWithParam<PracticalCase> {
 protected:
  static constexpr double kBound = 1.15;
  static constexpr std::size_t kEvery = 4;  // samples of the validation log
  Scratch scratch;

  SampledLog log(int joints) const {
    const auto rows = numbers_of(scratch.read("log.csv"));
    const auto count = static_cast<Eigen::Index>(rows.size());
    SampledLog result{1.0 / GetParam().rate, Eigen::MatrixXd(count, joints), Eigen::MatrixXd(count, joints)};
    for (Eigen::Index k = 0; k < count; ++k) {
      const Eigen::Map<const Eigen::RowVectorXd> row(rows[static_cast<std::size_t>(k)].data(), 2 * joints + 1);
      result.q.row(k) = row.segment(1, joints);
      result.tau.row(k) = row.tail(joints);
    }
    return result;
  }

  // Squares of torque errors in the validation log, by joint, summed over rows in which the joint moves.
  struct Squares {
    Eigen::ArrayXd own, other;  // of flatdyn's links, of the other program's parameters
    Eigen::ArrayXd put_in;      // of the torques that the arm's own parameters give: noise, ripple, friction near rest
    Eigen::ArrayXd rows;
  };
  Squares squares(const ParallelFilter& judge, const Eigen::VectorXd& pi, int n) const {
    const auto exact = numbers_of(scratch.read("validation_exact.csv")),
               measured = numbers_of(scratch.read("validation.csv")),
               found = torques(scratch.path("identified.toml"), scratch.path("validation_motion.csv"));
    EXPECT_EQ(found.size(), exact.size());
    const Eigen::ArrayXd zero = Eigen::ArrayXd::Zero(n);
    Squares sum{zero, zero, zero, zero};
    for (std::size_t k = 0; k < found.size(); k += kEvery) {
      const auto part = [n](const std::vector<double>& row, int first) {
        return Eigen::Map<const Eigen::VectorXd>(row.data() + 1 + first * n, n);
      };
      const auto qd = part(exact[k], 1), tau = part(measured[k], 1);
      const Eigen::ArrayXd moves = (qd.array() != 0).cast<double>();
      if (moves.maxCoeff() == 0) continue;
      sum.own += moves * (part(found[k], 3) - tau).array().square();
      sum.other += moves * (judge.matrix(part(exact[k], 0), qd, part(exact[k], 2)) * pi - tau).array().square();
      sum.put_in += moves * (part(exact[k], 3) - tau).array().square();
      sum.rows += moves;
    }
    return sum;
  }
};

// The other program has other filters and another regressor (support/parallel_filter.hpp).
TEST_P(PracticalExample, IsIdentifiedAsWellAsByAnotherProgram) {
  const auto& [robot, rate, evaluations] = GetParam();
  const std::string variables = fmt::format("RATE={} EVALUATIONS={}", rate, evaluations);
  ASSERT_EQ(run_example("identify_practical.sh", scratch.path(), robot, variables).code, 0) << scratch.read("err");
  const LoadedRobot arm = load_robot(scratch.path("truth.toml"), {});
  const int n = arm.mechanism.size();
  const ParallelFilter judge(arm, {});
  const Squares sum = squares(judge, judge.identified(log(n)), n);
  EXPECT_GT(sum.rows.minCoeff() * kEvery, 4.5 * rate);  // 5 s for the joint that is held, else 10
  EXPECT_GT(sum.rows.maxCoeff() * kEvery, 9 * rate);
  // Both leave what was put in, but for the part of friction near rest that F_s takes.
  const Eigen::ArrayXd own = (sum.own / sum.put_in).sqrt(), other = (sum.other / sum.put_in).sqrt();
  EXPECT_GT(own.minCoeff(), 0.8);
  EXPECT_GT(other.minCoeff(), 0.8);
  EXPECT_LT(own.maxCoeff(), 1.3);
  EXPECT_LT(other.maxCoeff(), 1.3);
  const Eigen::ArrayXd ratios = (sum.own / sum.other).sqrt();
  const double ratio = std::sqrt(sum.own.sum() / sum.other.sum());
  EXPECT_LT(ratio, kBound);
  EXPECT_LT(ratios.maxCoeff(), kBound);
  RecordProperty("ratio", fmt::format("{:.3f}", ratio));
  fmt::print("torque error to the other program's: {:.2f}, by joint {:.2f} to {:.2f}\n", ratio, ratios.minCoeff(),
             ratios.maxCoeff());
}

INSTANTIATE_TEST_SUITE_P(Robots, PracticalExample,
                         ::testing::Values(PracticalCase{"ur5", 500, 60}, PracticalCase{"panda", 1000, 1000}),
                         [](const auto& test) { return std::string(test.param.robot); });

}  // namespace
}  // namespace flatdyn::testing
