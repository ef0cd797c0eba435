// SPDX-License-Identifier: GPL-2.0-or-later
// flatdyn excite: its files, its output, and its exit codes.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/program.hpp"

namespace flatdyn::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr const char* kExcite = "excite robots/planar_2r_example_7_2.toml --evaluations 60 ";
constexpr const char* kCsv = "planar_2r_example_7_2_excitation.csv";
constexpr const char* kSvg = "planar_2r_example_7_2_excitation.svg";

TEST(Excite, WritesTheMotionAndItsPlot) {
  const Scratch scratch;
  const Outcome outcome = run_flatdyn(kExcite + std::string("--duration 5 --rate 40 -o ") + scratch.path("new"));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  for (const char* text : {"condition number", "theta_2", "most used", "the motion shows least", "wrote "}) {
    EXPECT_THAT(outcome.out, HasSubstr(text));
  }
  const std::string csv = scratch.read(fmt::format("new/{}", kCsv));
  EXPECT_THAT(csv, StartsWith("t,q1,q2,qd1,qd2,qdd1,qdd2,tau1,tau2\n0,0,0,0,0,0,0,"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 5 * 40 + 1);
  EXPECT_THAT(csv, HasSubstr("\n4.975,"));
  EXPECT_THAT(scratch.read(fmt::format("new/{}", kSvg)), HasSubstr("theta_1"));
}

TEST(Excite, KeepsToItsFolderWhateverTheRobotIsCalled) {
  const Scratch scratch;
  scratch.write("arm.toml", "name = \"../an/arm 1\"\n[[link]]\njoint = \"a\"\nmass = 1\ncom = [0.1, 0, 0]\n");
  const Outcome outcome = run_flatdyn(fmt::format("excite {} -q --evaluations 10 --duration 2 -o {}",
                                                  scratch.path("arm.toml"), scratch.path("folder")));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(scratch.read("folder/an_arm_1_excitation.csv"), StartsWith("t,q1,"));
}

// The expected torques are those of the recursive reference for the motion.
TEST(Excite, TorquesAreInverseDynamics) {
  const Scratch scratch;
  ASSERT_EQ(run_flatdyn(kExcite + std::string("-q --duration 5 --rate 20 -o ") + scratch.path()).code, 0);
  const Outcome outcome =
      run_flatdyn("eval robots/planar_2r_example_7_2.toml -q --json --reference --function inverse_dynamics --states " +
                  scratch.path(kCsv));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  for (const json& row : json::parse(outcome.out)["rows"]) {
    const auto number = [&row](std::size_t k) { return std::stod(row[k].get<std::string>()); };
    for (const std::size_t i : {0u, 1u}) {
      EXPECT_NEAR(number(7 + i), number(row.size() - 2 + i), 1e-9 * (1 + std::abs(number(7 + i))));
    }
  }
}

TEST(Excite, GivesTheSameBytesInEveryRun) {
  const Scratch scratch;
  for (const char* folder : {"a", "b"}) {
    ASSERT_EQ(run_flatdyn(kExcite + std::string("-q --duration 4 --rate 50 -o ") + scratch.path(folder)).code, 0);
  }
  for (const char* file : {kCsv, kSvg}) {
    EXPECT_EQ(scratch.read(fmt::format("a/{}", file)), scratch.read(fmt::format("b/{}", file)));
  }
}

// The motion of a first run is the log that a second one completes.
TEST(Excite, CompletesALog) {
  const Scratch scratch;
  const std::string command = kExcite + std::string("--rate 20 --duration 6 ");
  ASSERT_EQ(run_flatdyn(command + "-q -o " + scratch.path("first")).code, 0);
  const std::string log = scratch.path(fmt::format("first/{}", kCsv));
  const Outcome outcome = run_flatdyn(command + fmt::format("--seed 2 --data {} -o {}", log, scratch.path("second")));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("standard deviations of the parameters, found to the logs alone: 0."));
  EXPECT_THAT(outcome.out, HasSubstr("\n6.05 s of logs count beside every motion\n"));
  const Outcome as_json =
      run_flatdyn(command + fmt::format("--json --seed 2 --data {} -o {}", log, scratch.path("second")));
  const json ratios = json::parse(as_json.out)["logs"]["standard_deviations_to_logs"];
  EXPECT_LT(ratios["median"], 0.8);  // 1/sqrt(2) for twice the same
  EXPECT_LT(ratios["largest"], 1);
  EXPECT_NE(scratch.read(fmt::format("second/{}", kCsv)), scratch.read(fmt::format("first/{}", kCsv)));
}

TEST(Excite, RefusesLogsThatItCannotUse) {
  const Scratch scratch;
  scratch.write("arm.csv", "t,q1,q2,qd1,qd2,qdd1,qdd2,tau1,tau2\n0,0,0,0,0,1,1,1,1\n0.1,0,0,0.1,0.1,1,1,1,1\n");
  scratch.write("no_tau.csv", "t,q1,q2\n0,0,0\n0.1,0,0\n");
  const auto run = [&](const std::string& logs) {
    return run_flatdyn(kExcite + ("-q -o " + scratch.path("out") + " --data ") + logs);
  };
  const Outcome twice = run(scratch.path("arm.csv") + " " + scratch.path("arm.csv"));
  EXPECT_EQ(twice.code, 3);
  EXPECT_THAT(twice.err, HasSubstr("arm.csv: error: the same log as "));
  EXPECT_EQ(run(scratch.path("no_tau.csv")).code, 3);
  EXPECT_EQ(run(scratch.path("missing.csv")).code, 6);
}

TEST(Excite, JsonHasTheNumbers) {
  const Scratch scratch;
  const Outcome outcome = run_flatdyn(kExcite + std::string("--json --rate 20 --margin 0.5 -o ") + scratch.path());
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json result = json::parse(outcome.out);
  EXPECT_GE(result["condition_number"]["scaled"], 1.0);
  EXPECT_LT(result["condition_number"]["scaled"], result["condition_number_of_start"]["scaled"]);
  EXPECT_LT(result["condition_number"]["relative"], result["condition_number_of_start"]["relative"]);
  EXPECT_LE(result["standard_deviations_to_start"]["median"], result["standard_deviations_to_start"]["largest"]);
  EXPECT_EQ(result["samples"], 401);
  ASSERT_EQ(result["limits_used"].size(), 2u);
  for (const json& joint : result["limits_used"]) EXPECT_LE(joint["speed"], 0.5);
}

TEST(Excite, IsEndedByTheTimeWhereItIsGiven) {
  const Scratch scratch;
  const Outcome outcome =
      run_flatdyn("excite robots/panda.urdf --json -q --rate 20 --evaluations 100000 --time 0.2 -o " + scratch.path());
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json result = json::parse(outcome.out);
  EXPECT_TRUE(result["out_of_time"]);
  EXPECT_LT(result["evaluations"], 100000);
}

TEST(Excite, RefusesWhatItCannotDo) {
  const Scratch scratch;
  const std::string folder = " -o " + scratch.path("out");
  for (const std::string option : {"--harmonics 0", "--margin 1.5", "--rate 0", "--duration -1", "--evaluations 0",
                                   "--parameters some", "--rate 1 --duration 5", "--rate 10000 --duration 3600"}) {
    EXPECT_EQ(run_flatdyn(kExcite + option + folder).code, 2) << option;
  }
  EXPECT_EQ(run_flatdyn(kExcite).code, 2);
  EXPECT_EQ(run_flatdyn("excite robots/planar_2r.toml" + folder).code, 4);
  EXPECT_EQ(run_flatdyn(kExcite + std::string("-o /proc/nowhere")).code, 6);
  EXPECT_TRUE(scratch.is_empty());
}

}  // namespace
}  // namespace flatdyn::testing
