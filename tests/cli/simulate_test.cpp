// SPDX-License-Identifier: GPL-2.0-or-later
// flatdyn simulate: its files, its messages for bad input, and Ctrl-C.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <numbers>
#include <vector>

#include "cli/csv_numbers.hpp"
#include "cli/program.hpp"
#include "support/frictional_arm.hpp"

namespace flatdyn::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr const char* kSimulate = "simulate robots/planar_2r_example_7_2.toml -q ";

TEST(Simulate, WritesMotionEventsAndPlot) {
  const Scratch scratch;
  const Outcome outcome =
      run_flatdyn(fmt::format("simulate robots/puma560.toml --duration 3 --rate 100 -o {} --events {} --plot {}",
                              scratch.path("m.csv"), scratch.path("e.csv"), scratch.path("m.svg")));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("energies add up within "));
  EXPECT_THAT(outcome.out, HasSubstr("shoulder rests"));
  EXPECT_THAT(outcome.out, HasSubstr("wrote " + scratch.path("m.svg") + "\n"));
  const std::string csv = scratch.read("m.csv");
  EXPECT_THAT(csv, StartsWith("t,q1,q2,q3,q4,q5,q6,qd1,"));
  EXPECT_THAT(csv, HasSubstr(",friction6,kinetic,potential,work,dissipated\n0,0,0,"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 302);
  EXPECT_THAT(scratch.read("e.csv"), StartsWith("t,joint,event\n0."));
  EXPECT_THAT(scratch.read("m.svg"), HasSubstr("energies"));
}

constexpr const char* kThrown = R"(duration = 0.5
rate = 20
[start]
base_position = [0, 0, 2]
base_orientation = [0.6, 0, 0.8, 0]
base_velocity = [1, 0, 0, 0.1, 4, 0.2]
)";

constexpr const char* kThrownBody = R"(name = "body"
[base]
motion = "floating"
mass = 2
com = [0.1, 0, 0]
inertia = { xx = 0.1, yy = 0.2, zz = 0.3 }
inertia_about = "com"
[[link]]
joint = "wheel"
xyz = [0.2, 0, 0]
mass = 0.5
com = [0, 0.1, 0]
inertia = { xx = 0.01, yy = 0.01, zz = 0.02 }
inertia_about = "com"
)";

// `eval` can read the motion of a floating base, and finds that no force acts on it.
TEST(Simulate, ThrowsARobotWithAFloatingBase) {
  const Scratch scratch;
  scratch.write("body.toml", kThrownBody);
  scratch.write("thrown.toml", kThrown);
  const Outcome outcome =
      run_flatdyn(fmt::format("simulate {} --simulation {} -o {} --plot {}", scratch.path("body.toml"),
                              scratch.path("thrown.toml"), scratch.path("m.csv"), scratch.path("m.svg")));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("momentum adds up within "));
  const std::string csv = scratch.read("m.csv");
  EXPECT_THAT(csv, StartsWith("t,base_x,base_y,base_z,base_qw,base_qx,base_qy,base_qz,q1,base_vx,base_vy,base_vz,"
                              "base_wx,base_wy,base_wz,qd7,base_dvx,"));
  EXPECT_THAT(csv, HasSubstr(",base_nz,tau7,friction7,kinetic,potential,work,dissipated,base_gx,base_gy,base_gz,"
                             "momentum_x,momentum_y,momentum_z,angular_momentum_x,"));
  const Outcome again = run_flatdyn("eval " + scratch.path("body.toml") +
                                    " -q --json --function inverse_dynamics --states " + scratch.path("m.csv"));
  ASSERT_EQ(again.code, 0) << again.err;
  const json rows = json::parse(again.out).at("rows");
  ASSERT_EQ(rows.size(), 11u);
  for (const json& row : rows) {
    for (std::size_t k = row.size() - 7; k < row.size(); ++k) {
      EXPECT_NEAR(std::stod(row[k].get<std::string>()), 0, 1e-9) << row;
    }
  }
}

TEST(Simulate, SaysWhatIsWrongAboutAFloatingBase) {
  const Scratch scratch;
  scratch.write("body.toml", kThrownBody);
  const auto told = [&scratch](const std::string& simulation) {
    scratch.write("run.toml", simulation);
    const Outcome outcome = run_flatdyn("simulate " + scratch.path("body.toml") + " --simulation " +
                                        scratch.path("run.toml") + " -o " + scratch.path("m.csv"));
    EXPECT_EQ(outcome.code, 3) << simulation;
    return outcome.err;
  };
  EXPECT_THAT(told("[start]\nbase_orientation = [1, 1, 0, 0]\n"),
              HasSubstr("run.toml:2: error: base_orientation: a quaternion's length is 1.41421, not 1"));
  EXPECT_THAT(told("[start]\nbase_velocity = 1\n"), HasSubstr("run.toml:2: error: base_velocity: it is no list"));
  EXPECT_THAT(told("[start]\nbase_position = [1, 2]\n"), HasSubstr("run.toml:2: error: "));
  EXPECT_THAT(told("[torque.computed_torque]\nkp = 1\n"),
              HasSubstr("run.toml:1: error: computed_torque: motors do not drive a floating base"));
}

// `eval` can read the simulation, and finds the torques that it was given: none.
TEST(Simulate, FallsWithoutTorques) {
  const Scratch scratch;
  ASSERT_EQ(run_flatdyn(kSimulate + ("--duration 2 --rate 20 -o " + scratch.path("fall.csv"))).code, 0);
  const Outcome outcome =
      run_flatdyn("eval robots/planar_2r_example_7_2.toml -q --json --reference --function inverse_dynamics --states " +
                  scratch.path("fall.csv"));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json rows = json::parse(outcome.out)["rows"];
  ASSERT_EQ(rows.size(), 41U);
  for (const json& row : rows) {
    EXPECT_NEAR(std::stod(row[row.size() - 1].get<std::string>()), 0, 1e-9);
    EXPECT_NEAR(std::stod(row[row.size() - 2].get<std::string>()), 0, 1e-9);
  }
}

TEST(Simulate, GivesTheSameBytesInEveryRun) {
  const Scratch scratch;
  for (const char* name : {"a.csv", "b.csv"}) {
    ASSERT_EQ(run_flatdyn(kSimulate + ("--duration 1 -o " + scratch.path(name))).code, 0);
  }
  EXPECT_EQ(scratch.read("a.csv"), scratch.read("b.csv"));
}

TEST(Simulate, DrivesWithSampledTorques) {
  const Scratch scratch;
  scratch.write("tau.csv", "t,tau_theta_2,tau_theta_1\n0,1,2\n0.5,3,4\n");
  scratch.write("run.toml", "duration = 1\nrate = 4\n[torque]\nsamples = \"tau.csv\"\n");
  const Outcome outcome =
      run_flatdyn(kSimulate + fmt::format("--simulation {} -o {}", scratch.path("run.toml"), scratch.path("m.csv")));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::string csv = scratch.read("m.csv");
  EXPECT_THAT(csv, HasSubstr(",3,2,"));  // at 0.25 s, half-way
  EXPECT_THAT(csv, HasSubstr(",4,3,"));  // after the last sample
}

// No output replaces an input of the simulation.
TEST(Simulate, KeepsItsInputs) {
  const Scratch scratch;
  scratch.write("tau.csv", "t,tau1,tau2\n0,1,2\n");
  scratch.write("run.toml", "duration = 0.1\n[torque]\nsamples = \"tau.csv\"\n");
  for (const char* input : {"tau.csv", "run.toml"}) {
    const std::string before = scratch.read(input);
    const Outcome outcome =
        run_flatdyn(kSimulate + fmt::format("--simulation {} -o {}", scratch.path("run.toml"), scratch.path(input)));
    EXPECT_EQ(outcome.code, 2) << input;
    EXPECT_EQ(scratch.read(input), before);
  }
}

// Inverse, then forward dynamics over a whole motion: the torques of `torques` move the arm along it.
TEST(Simulate, MovesAlongTheMotionThatItsTorquesAreOf) {
  const Scratch scratch;
  const Outcome torques = run_flatdyn(
      "torques robots/planar_2r_example_7_2.toml -q --trajectory docs/examples/planar_2r_trapezoidal.toml -o " +
      scratch.path("tau.csv"));
  ASSERT_EQ(torques.code, 0) << torques.err;
  const std::vector<std::vector<double>> wanted = numbers_of(scratch.read("tau.csv"));
  scratch.write("run.toml",
                fmt::format("duration = {}\nrate = 100\n[start]\nq = [{}, {}]\n[torque]\nsamples = \"tau.csv\"\n",
                            wanted.back()[0], wanted[0][1], wanted[0][2]));
  const Outcome outcome =
      run_flatdyn(kSimulate + fmt::format("--simulation {} -o {}", scratch.path("run.toml"), scratch.path("m.csv")));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::vector<std::vector<double>> found = numbers_of(scratch.read("m.csv"));
  // The torques are linear between samples, but jump within one interval, which causes the difference.
  for (const std::size_t joint : {1u, 2u}) EXPECT_NEAR(found.back()[joint], wanted.back()[joint], 0.02);
}

// A computed-torque law corrects a wrong start, and then follows the trajectory.
TEST(Simulate, FollowsATrajectory) {
  const Scratch scratch;
  const Outcome outcome =
      run_flatdyn(kSimulate + ("--simulation docs/examples/planar_2r_tracking.toml -o " + scratch.path("m.csv")));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::vector<std::vector<double>> rows = numbers_of(scratch.read("m.csv"));
  const std::vector<double>& start = rows.front();
  EXPECT_NEAR(start[1], -1.42, 1e-12);
  // From tip (0.2, 0) both joints turn by pi/2 in 0.5 s; then the arm stands.
  const double end_1 = -std::acos(0.1) + std::numbers::pi / 2, end_2 = 2 * std::acos(0.1) + std::numbers::pi / 2;
  EXPECT_NEAR(rows.back()[1], end_1, 1e-3);
  EXPECT_NEAR(rows.back()[2], end_2, 1e-3);
}

// The impact of one joint frees the other from its stop, which falls back, and so on: they come to rest nevertheless.
TEST(Simulate, JointsAtTheirStopsSettle) {
  const Scratch scratch;
  scratch.write("arm.toml", kFrictionalArm);
  scratch.write("run.toml",
                "duration = 3\nrate = 10\njoint_limits = \"stop\"\n[start]\nq = [-0.38, 0.25]\nqd = [1.9, 0]\n"
                "[torque]\nconstant = [-17.26, 15.92]\n");
  const Outcome outcome =
      run_flatdyn(fmt::format("simulate {} -q --json --simulation {} -o {}", scratch.path("arm.toml"),
                              scratch.path("run.toml"), scratch.path("m.csv")));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json told = json::parse(outcome.out);
  EXPECT_LT(told["events"].size(), 200U);
  EXPECT_LT(told["energy_error"].get<double>(), 1e-5);
}

TEST(Simulate, EndsWhereAControllerIsUnstable) {
  const Scratch scratch;
  scratch.write("arm.toml", kFrictionalArm);
  scratch.write("run.toml",
                "duration = 20\n[torque.pd]\nkp = [200, 100]\nkd = [20, 10]\nposition = [0.2, 0.3]\nperiod = 0.1\n");
  const Outcome outcome = run_flatdyn(fmt::format("simulate {} -q --simulation {} -o {}", scratch.path("arm.toml"),
                                                  scratch.path("run.toml"), scratch.path("m.csv")));
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("a joint is faster than 100000 rad/s or m/s"));
}

// An error budget is about functions that are written; simulate does not ask for the limits that it needs.
TEST(Simulate, AnErrorBudgetHasNoEffect) {
  const Scratch scratch;
  scratch.write("scene.toml", "error_budget = \"1%\"\n");
  const Outcome outcome = run_flatdyn("simulate robots/planar_2r_example_7_2.toml --duration 0.1 --scene " +
                                      scratch.path("scene.toml") + " -o " + scratch.path("m.csv"));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("error_budget"));
}

// The last row is at the end of the motion.
TEST(Simulate, EndsWithARowOfItsOwn) {
  const Scratch scratch;
  ASSERT_EQ(run_flatdyn(kSimulate + ("--duration 0.25 --rate 10 -o " + scratch.path("m.csv"))).code, 0);
  const std::vector<std::vector<double>> rows = numbers_of(scratch.read("m.csv"));
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[2][0], 0.2);
  EXPECT_EQ(rows[3][0], 0.25);
}

TEST(Simulate, AsksAboutTimesInMilliseconds) {
  const Scratch scratch;
  scratch.write("tau.csv", "t,tau1,tau2\n0,0,0\n10,0,0\n20,0,0\n");
  scratch.write("run.toml", "duration = 0.1\n[torque]\nsamples = \"tau.csv\"\n");
  const Outcome outcome =
      run_flatdyn(kSimulate + fmt::format("--simulation {} -o {}", scratch.path("run.toml"), scratch.path("m.csv")));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("tau.csv:1: warning: from one sample to the next, 10 s pass\n"
                                     "    hint: is the time in ms? Then write the column's heading as t [ms]"));
}

TEST(Simulate, CtrlCLeavesAValidFile) {
  const Scratch scratch;
  const std::string command = fmt::format(
      "timeout --signal=INT --preserve-status 3 '{}' simulate '{}/robots/panda.urdf' -q --duration 90000 "
      "--rate 10 -o '{}' 2> '{}'",
      FLATDYN_PROGRAM, FLATDYN_SOURCE_DIR, scratch.path("m.csv"), scratch.path("err"));
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 130);  // NOLINT(cert-env33-c): the shell's `timeout`
  EXPECT_THAT(scratch.read("err"), HasSubstr("interrupted at t = "));
  const std::string csv = scratch.read("m.csv");
  EXPECT_THAT(csv, StartsWith("t,q1,"));
  EXPECT_EQ(csv.back(), '\n');
  EXPECT_GT(std::count(csv.begin(), csv.end(), '\n'), 2);
}

struct BadInput {
  const char* text;
  const char* message;
};

class BadSimulation : public ::testing::TestWithParam<BadInput> {};

TEST_P(BadSimulation, IsDiagnosedWithItsLine) {
  const Scratch scratch;
  scratch.write("run.toml", GetParam().text);
  scratch.write("empty.csv", "time,tau1,tau2\n");
  scratch.write("unsorted.csv", "time,tau1,tau2\n0,0,0\n1,0,0\n1,0,0\n");
  scratch.write("infinite.csv", "time,tau1,tau2\n0,inf,0\n");
  scratch.write("columns.csv", "time,tau1,torque2\n0,0,0\n");
  const Outcome outcome =
      run_flatdyn(kSimulate + fmt::format("--simulation {} -o {}", scratch.path("run.toml"), scratch.path("m.csv")));
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr(GetParam().message));
  const std::size_t first = outcome.err.find(GetParam().message);
  EXPECT_EQ(outcome.err.find(GetParam().message, first + 1), std::string::npos) << "said twice";
  EXPECT_FALSE(std::filesystem::exists(scratch.path("m.csv")));
}

INSTANTIATE_TEST_SUITE_P(
    Simulate, BadSimulation,
    ::testing::Values(
        BadInput{"duration = 0\n", "run.toml:1: error: duration: 0 is not positive"},
        BadInput{"\nrate = -1\n", "run.toml:2: error: rate: -1 is not positive"},
        BadInput{"duration = inf\n", "run.toml:1: error: "}, BadInput{"duraton = 1\n", "did you mean \"duration\""},
        BadInput{"joint_limits = \"stopp\"\n", "run.toml:1: error: joint_limits: \"stopp\" is none of its values"},
        BadInput{"[start]\nq = [1, 2, 3]\n", "run.toml:2: error: start, q: a list of 2 numbers, or one number"},
        BadInput{"[start]\nq = \"a_1\"\n", "run.toml:2: error: start, q: a symbol stands for no number here"},
        BadInput{"[torque]\nsamples = \"empty.csv\"\n", "empty.csv: error: no states in the file"},
        BadInput{"[torque]\nsamples = \"unsorted.csv\"\n", "unsorted.csv:4: error: time 1 does not come after 1"},
        BadInput{"[torque]\nsamples = \"infinite.csv\"\n", "infinite.csv:2: error: column \"tau1\": \"inf\""},
        BadInput{"[torque]\nsamples = \"columns.csv\"\n", "columns.csv:1: error: no column for the torques: tau2"},
        BadInput{"[torque.pd]\ntrajectory = \"columns.csv\"\n", "columns.csv:1: error: "},
        BadInput{"[torque.pd]\nposition = 1\ntrajectory = \"columns.csv\"\n",
                 "run.toml:3: error: trajectory and position"},
        BadInput{"[torque.pd]\nperiod = 1e-9\n", "run.toml:2: error: period: 1e-09 is not above 1e-07"},
        BadInput{"[torque]\nbetween = \"hold\"\n", "run.toml:2: error: torque: between what?"},
        BadInput{"[torque.pd]\nkp = 1\n[torque.computed_torque]\nkp = 1\n", "run.toml:3: error: torque: two of "}));

TEST(Simulate, RefusesWhatItCannotDo) {
  const Scratch scratch;
  const Outcome symbols = run_flatdyn("simulate robots/planar_2r.toml -q -o " + scratch.path("m.csv"));
  EXPECT_EQ(symbols.code, 4);
  EXPECT_THAT(symbols.err, HasSubstr("a simulation needs numbers"));
  EXPECT_EQ(run_flatdyn(kSimulate + ("--duration 1e6 --rate 1e6 -o " + scratch.path("m.csv"))).code, 2);
  EXPECT_EQ(run_flatdyn(kSimulate + ("--tolerance 0 -o " + scratch.path("m.csv"))).code, 2);
  EXPECT_EQ(run_flatdyn(kSimulate + ("--simulation none.toml -o " + scratch.path("m.csv"))).code, 6);
  EXPECT_EQ(run_flatdyn(kSimulate + ("-o " + scratch.path("m.csv") + " --plot " + scratch.path("m.csv"))).code, 2);
  EXPECT_TRUE(scratch.is_empty());
}

}  // namespace
}  // namespace flatdyn::testing
