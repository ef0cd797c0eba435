// SPDX-License-Identifier: GPL-2.0-or-later
// flatdyn identify as a user runs it: a log as input, a robot file as output, and spread over ranks.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/program.hpp"
#include "cli/torques_of_log.hpp"
#include "support/robot_models.hpp"
#include "support/simulated_log.hpp"
#include "support/written_model.hpp"

namespace flatdyn::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

constexpr const char* kPuma = "robots/puma560.toml";

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

// A body with a hinge, a ball, a slide and a branch flies freely, driven by its joints. Its parameters come from what
// `simulate` writes of that, with masses in the file that are wrong: torques give the scale, and nothing touches the
// base.
TEST(Identify, FindsAFlyingRobotByItsOwnMotion) {
  const Scratch scratch;
  std::string torques = "time,tau_hinge,tau_ball.wx,tau_ball.wy,tau_ball.wz,tau_slide,tau_thumb\n";
  for (int k = 0; k <= 800; ++k) {
    const double t = 0.005 * k;
    torques += fmt::format("{},{},{},{},{},{},{}\n", t, 2 * std::sin(4 * t + 1), 0.5 * std::sin(5 * t),
                           0.6 * std::cos(3.3 * t), 0.4 * std::sin(6.1 * t + 2), 3 * std::sin(7 * t),
                           0.05 * std::sin(9 * t + 0.4));
  }
  scratch.write("torques.csv", torques);
  scratch.write("flight.toml",
                "duration = 4\nrate = 250\n[start]\nbase_velocity = [0, 0, 0, 0.3, 0.2, -0.4]\n"
                "[torque]\nsamples = \"torques.csv\"\n");
  const std::string robot = "docs/examples/free_arm.toml";
  const Outcome flight = run_flatdyn(
      fmt::format("simulate {} --simulation {} -o {} -q", robot, scratch.path("flight.toml"), scratch.path("log.csv")));
  ASSERT_EQ(flight.code, 0) << flight.err;
  scratch.write("wrong.toml", fmt::format("robot = \"{}/{}\"\n[[link]]\nname = \"hand\"\nmass = 2.6\n"
                                          "[[link]]\nname = \"link1\"\nmass = 4\n",
                                          FLATDYN_SOURCE_DIR, robot));
  const Outcome found = run_flatdyn(fmt::format("identify {} --data {} -q --json -o {}", scratch.path("wrong.toml"),
                                                scratch.path("log.csv"), scratch.path("found.toml")));
  ASSERT_EQ(found.code, 0) << found.err;
  const Outcome truth = run_flatdyn(fmt::format("identify {} --data {} -q --json", robot, scratch.path("log.csv")));
  const json of_wrong = json::parse(found.out)["base_parameters"], of_file = json::parse(truth.out)["base_parameters"];
  ASSERT_EQ(of_wrong.size(), of_file.size());
  double difference = 0, in_file = 0;
  for (std::size_t k = 0; k < of_file.size(); ++k) {
    const double value = of_wrong[k]["value"], expected = of_file[k]["file"], before = of_wrong[k]["file"];
    EXPECT_NEAR(value, expected, 1e-6) << of_file[k]["kept"];
    difference = std::max(difference, std::abs(before - expected));
    in_file += std::abs(expected);
  }
  EXPECT_GT(difference, 1);
  EXPECT_GT(in_file, 10);
}

// A log is not judged by itself, and options that cannot have an effect are refused before logs are read.
TEST(Identify, RefusesOptionsWithoutAnEffect) {
  const Scratch scratch;
  scratch.write("log.csv", "t,q1,q2,tau1,tau2\n");
  const std::string log = scratch.path("log.csv"),
                    identify = "identify robots/planar_2r_example_7_2.toml --data " + log;
  for (const auto& [options, message] :
       {std::pair<std::string, const char*>{" --validate " + log, "that log is one of --data, too"},
        {" --parameters inertial --friction stribeck",
         "--friction and --temperature have no effect with --parameters inertial"},
        {" --parameters given --friction load", "no friction is among the parameters"},
        {" --temperature 300", "must be a number from -100 to 200"},
        {" --gravity off --gravity-direction", "the robot is without gravity"},
        {" --springs --offsets", "--springs cannot be told apart from --offsets"},
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
    EXPECT_NEAR(parameter["value"], truth, 1.5e-3 * truth) << parameter["kept"];
    ++checked;
  }
  EXPECT_EQ(checked, 16);
}

// A tendon has friction and an armature, and no inertial parameters.
TEST(Identify, FindsTheForcesOfTendons) {
  const Scratch scratch;
  const std::string text = R"(gravity = [0, -9.81, 0]
[[link]]
joint = "i"
mass = 2
com = [0.3, 0.1, 0]
inertia = { zz = 0.2 }
inertia_about = "com"
[[link]]
joint = "j"
xyz = [0.5, 0, 0]
mass = 1
com = [0.2, 0, 0]
inertia = { zz = 0.1 }
inertia_about = "com"
[[tendon]]
name = "t"
length = "0.5*i - 2*j + 0.7"
viscous = 1.5
coulomb = 0.5
armature = 0.3
)";
  scratch.write("r.toml", text);
  write_log(scratch.path("log.csv"), simulated(model_of_toml(text), {.samples = 400}));
  const Outcome found =
      run_flatdyn(fmt::format("identify {} -q --json --data {}", scratch.path("r.toml"), scratch.path("log.csv")));
  ASSERT_EQ(found.code, 0) << found.err;
  int checked = 0;
  const json result = json::parse(found.out);
  for (const json& parameter : result["base_parameters"]) {
    const std::string kept = parameter["kept"];
    const double truth = kept == "Fv3" ? 1.5 : kept == "Fs3" ? 0.5 : kept == "Im3" ? 0.3 : 0;
    if (truth == 0) continue;
    EXPECT_NEAR(parameter["value"], truth, 1e-3) << kept;
    ++checked;
  }
  EXPECT_EQ(checked, 3) << found.out;
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
      {"identify robots/planar_2r_example_7_2.toml --estimator iv --data " + log, 2, "--estimator iv needs the filter"},
      {"identify docs/examples/ball_wrist.toml --gravity-direction --data " + log, 4,
       "--gravity-direction is for robots without spherical joints"},
      {"identify docs/examples/free_arm.toml --gravity-direction --data " + log, 4,
       "--gravity-direction is for robots with a fixed base"},
      {"identify robots/planar_2r_example_7_2.toml --imu x --data " + log, 2,
       "--imu is for robots with a floating base"},
      {"identify robots/planar_2r_example_7_2.toml --merge x --rest-speed 0", 2,
       "--rest-speed and --imu have no effect with"},
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

TEST(Identify, SaysThatALogIsTooShortForTheFilter) {
  const Scratch scratch;
  write_log(scratch.path("log.csv"), simulated(model_of("puma560.toml"), {.samples = 50}), LogDerivatives::none);
  const Outcome outcome = run_flatdyn(fmt::format("identify {} -q --data {}", kPuma, scratch.path("log.csv")));
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("none of 50 samples can be used: the filter's window has 143 of them"));
}

// The weight on an upright prismatic joint and asymmetric friction are one constant force. The links that are written
// have some mass, and the asymmetry that is reported with them makes up for the rest.
TEST(Identify, GivesTheFrictionThatGoesWithTheLinks) {
  constexpr double kMass = 5, kGravity = 9.81, kAsymmetric = 30, kCoulomb = 8;  // kg, m/s^2, N, N
  const Scratch scratch;
  scratch.write("lift.toml",
                "dh = \"standard\"\ngravity = [0, 0, \"-9.81\"]\n[[link]]\njoint = \"lift\"\ntype = \"prismatic\"\n"
                "mass = 5\ninertia = { xx = 0.1, yy = 0.1, zz = 0.1 }\ninertia_about = \"com\"\n");
  std::vector<SimulatedSample> samples =
      simulated(load_robot(scratch.path("lift.toml"), {}), {.samples = 2000, .noise = 0.5});
  for (SimulatedSample& sample : samples) {
    sample.tau(0) += kAsymmetric + kCoulomb * ((sample.qd(0) > 0) - (sample.qd(0) < 0));
  }
  write_log(scratch.path("log.csv"), samples);
  const Outcome outcome =
      run_flatdyn(fmt::format("identify {} -q --json --friction asymmetric --data {} -o {}", scratch.path("lift.toml"),
                              scratch.path("log.csv"), scratch.path("found.toml")));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json further = json::parse(outcome.out)["further_parameters"].at(0);
  const double mass =
      nearest_double(load_robot(scratch.path("found.toml"), {}).robot.links.back().inertials.front().mass.number);
  EXPECT_NEAR(mass * kGravity + further["value_with_links"].get<double>(), kMass * kGravity + kAsymmetric, 0.3);
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
  // Few of the samples are of a motion.
  for (std::size_t k = 480; k < 520; ++k) samples[k].q[0] += 0.3 * std::sin(0.16 * static_cast<double>(k - 480));
  write_log(scratch.path("brief.csv"), samples, LogDerivatives::none);
  write_log(scratch.path("poses.csv"), simulated(robot, {.samples = 40, .rate = 0.5, .standing = true}),
            LogDerivatives::none);
  for (const auto& [arguments, message] :
       {std::pair{"motion.csv --decimate 100000", "none of 1000 samples can be used: --decimate 100000 leaves none"},
        {"held.csv --parameters full", "no joint moves faster than the speed below which it counts as resting"},
        {"brief.csv --parameters full", "every joint moves clearly faster than the noise of its position at few"},
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

}  // namespace
}  // namespace flatdyn::testing
