// SPDX-License-Identifier: GPL-2.0-or-later
// flatdyn payload as a user runs it.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/program.hpp"
#include "cli/torques_of_log.hpp"
#include "support/robot_models.hpp"
#include "support/simulated_log.hpp"

namespace flatdyn::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

constexpr const char* kLoadedPuma = "robots/puma560.toml";
constexpr const char* kArmInFlight = "docs/examples/free_arm.toml";

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
      run_flatdyn(fmt::format("payload {} -q --json --data {} --without {} -o {}", kLoadedPuma,
                              scratch.path("with.csv"), scratch.path("without.csv"), scratch.path("loaded.toml")));
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
  const std::string command = fmt::format("payload {} -o {} --data ", kLoadedPuma, scratch.path("loaded.toml"));
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

// The log of a free flight by `simulate`: a body with a hinge, a ball, a slide and a branch, which has turned its
// joints somewhere, and drives them by so much.
void fly(const Scratch& scratch, const std::string& robot, const std::string& log, double drive, double turns) {
  std::string torques = "time,tau_hinge,tau_ball.wx,tau_ball.wy,tau_ball.wz,tau_slide,tau_thumb\n";
  for (int k = 0; k <= 400; ++k) {
    const double t = 0.005 * k;
    torques += fmt::format("{},{},{},{},{},{},{}\n", t, drive * 2 * std::sin(4 * t + 1), drive * 0.5 * std::sin(5 * t),
                           drive * 0.6 * std::cos(3.3 * t), drive * 0.4 * std::sin(6.1 * t + 2),
                           drive * 3 * std::sin(7 * t), drive * 0.05 * std::sin(9 * t + 0.4));
  }
  scratch.write("torques.csv", torques);
  scratch.write("flight.toml",
                fmt::format("duration = 2\nrate = 100\n[start]\nbase_velocity = [0, 0, 0, {0}, 0.7, -0.4]\n"
                            "qd = [{0}, 1, -0.6, 0.8, 0.02, -2]\n[torque]\nsamples = \"torques.csv\"\n",
                            turns));
  const Outcome flight = run_flatdyn(
      fmt::format("simulate {} --simulation {} -o {} -q", robot, scratch.path("flight.toml"), scratch.path(log)));
  ASSERT_EQ(flight.code, 0) << flight.err;
}

// The payload of a hand in flight, against the file and against a flight without it. Torques give the scale. Where
// there are none, all masses may be multiplied by the same number.
TEST(Payload, IsFoundOnARobotThatFlies) {
  const double expected[] = {0.4, 0.012, -0.008, 0.02, 0.00216, 0.00024, -0.0006, 0.00256, 0.0004, 0.00142};
  const Scratch scratch;
  scratch.write("truth.toml", fmt::format("robot = \"{}/{}\"\n[payload]\nlink = \"hand\"\nmass = 0.4\n"
                                          "com = [0.03, -0.02, 0.05]\ninertia_about = \"com\"\n"
                                          "inertia = {{ xx = 0.001, yy = 0.0012, zz = 0.0009 }}\n",
                                          FLATDYN_SOURCE_DIR, kArmInFlight));
  const std::string with = " --data " + scratch.path("with.csv"), without = " --without " + scratch.path("without.csv"),
                    payload = fmt::format("payload {} -q --json --parameters given --tip hand", kArmInFlight);
  for (const double drive : {0.0, 1.0}) {
    fly(scratch, scratch.path("truth.toml"), "with.csv", drive, 1.5);
    fly(scratch, kArmInFlight, "without.csv", drive, -1.2);
    for (const std::string& against : {std::string(), without}) {
      if (drive == 0 && against.empty()) continue;
      const bool has_scale = drive > 0;
      const Outcome found = run_flatdyn(payload + with + against + " -o " + scratch.path("loaded.toml"));
      ASSERT_EQ(found.code, 0) << found.err;
      const json result = json::parse(found.out);
      EXPECT_EQ(result["equations"][0]["name"], "base_fx");
      EXPECT_EQ(result["untold"].size(), has_scale ? 0 : 1) << found.err;
      EXPECT_EQ(found.err.empty(), has_scale) << found.err;
      for (std::size_t k = 0; k < 10; ++k) {
        const double value = has_scale ? result["parameters"][k]["value"].get<double>()
                                       : expected[0] * result["untold"][0][k].get<double>();
        EXPECT_NEAR(value, expected[k], 1e-7) << k << against << drive;
      }
      if (has_scale) continue;
      EXPECT_THAT(found.err,
                  HasSubstr("the logs do not tell the payload's mass: nothing that was measured depends on it"));
    }
  }
  const LoadedRobot loaded = load_robot(scratch.path("loaded.toml"), {});
  EXPECT_TRUE(loaded.mechanism.floating_base);
  EXPECT_TRUE(loaded.robot.has_payload);
}

// Options are checked before logs are read, and logs as identify checks them.
TEST(Payload, SaysWhatAFloatingBaseNeeds) {
  const Scratch scratch;
  scratch.write("log.csv", "t,q1,q2,tau1,tau2\n");
  scratch.write("hinge.toml",
                "[base]\nname = \"body\"\nmotion = \"floating\"\nmass = 5\n[[link]]\nname = \"arm\"\nmass = 2\n"
                "com = [0.2, 0, 0]\n");
  const std::string hinge = scratch.path("hinge.toml"), log = scratch.path("log.csv");
  scratch.write("bare.csv", "t,q1,tau7\n0,0,0\n1,0,0\n");
  std::string joints = "t,q1,tau7,imu_ax,imu_ay,imu_az,imu_wx,imu_wy,imu_wz\n";
  for (int k = 0; k < 900; ++k) {
    const double t = 0.005 * k;
    joints += fmt::format("{},{},{},{},0,9.81,{},0,{}\n", t, std::sin(3 * t), std::cos(2 * t), std::sin(2 * t),
                          std::sin(t), std::cos(4 * t));
  }
  scratch.write("joints.csv", joints);
  const std::tuple<std::string, int, std::string> cases[] = {
      {kLoadedPuma + std::string(" --imu x --data ") + log, 2, "--imu is for robots with a floating base"},
      {hinge + " --imu x --data " + log, 2, "the robot has no link \"x\""},
      {hinge + " --imu arm --data " + log, 2, "link \"arm\" moves against the base link"},
      {hinge + " --data " + scratch.path("bare.csv"), 3, "no columns that tell the motion of the floating base"},
      {hinge + " --wrist --data " + scratch.path("joints.csv"), 3, "no columns fx, fy, fz, mx, my, mz"},
      {hinge + " --tip body --data " + scratch.path("joints.csv"), 3,
       "the logs tell nothing of what link \"body\" carries\n    hint: --tip names the link that carries the payload; "
       "no "
       "log has the force on the base, base_fx to base_nz"},
  };
  for (const auto& [arguments, code, message] : cases) {
    const Outcome outcome = run_flatdyn("payload -q " + arguments);
    EXPECT_EQ(outcome.code, code) << arguments;
    EXPECT_THAT(outcome.err, HasSubstr(message)) << arguments;
  }
}

}  // namespace
}  // namespace flatdyn::testing
