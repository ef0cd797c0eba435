// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/program.hpp"

namespace flatdyn::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kFew = " --states 50 --edges 30 --evaluations 50";
const std::string kShort = std::string(" -q") + kFew;

TEST(Stress, FindsWorstStatesThatEvalRepeats) {
  const Scratch scratch;
  const Outcome outcome =
      run_flatdyn("stress robots/prismatic_revolute.toml --functions inverse_dynamics -o " + scratch.path() + kShort);
  EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
  for (const char* text : {"inverse_dynamics  double", "inverse_dynamics  float", "condition", "ratio"}) {
    EXPECT_THAT(outcome.out, HasSubstr(text));
  }
  EXPECT_THAT(scratch.read("stress.svg"), HasSubstr("error against condition, double"));
  const auto row = nlohmann::json::parse(scratch.read("stress.json"))["rows"][0];
  EXPECT_EQ(row["states"], 50);
  EXPECT_EQ(row["variants"].size(), 10u);
  EXPECT_EQ(row["variants"]["cuda-double"], row["variants"]["double"]);
  EXPECT_EQ(row["worst"]["state"], scratch.read("worst_inverse_dynamics_double.csv"));
  // The graph of the emitted code has the reference's values there, up to the last places.
  const std::string eval = "eval robots/prismatic_revolute.toml -q --function inverse_dynamics --states " +
                           scratch.path("worst_inverse_dynamics_double.csv");
  const Outcome graph = run_flatdyn(eval), reference = run_flatdyn(eval + " --reference");
  EXPECT_EQ(graph.code, 0) << graph.err;
  EXPECT_EQ(reference.code, 0) << reference.err;
}

TEST(Stress, DrawsTheMotionOfAFloatingBase) {
  const Scratch scratch;
  const Outcome outcome = run_flatdyn(
      "stress robots/prismatic_revolute.toml --base floating --functions inverse_dynamics --variants "
      "double,batch-double,cuda-double -o " +
      scratch.path() + kShort);
  EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
  const auto row = nlohmann::json::parse(scratch.read("stress.json"))["rows"][0];
  EXPECT_THAT(std::string(row["worst"]["state"]), HasSubstr("base_gx,base_gy,base_gz"));
}

// Zero has no place on a logarithmic axis, and a scalar that was not asked for has no panel.
TEST(Stress, SaysThatErrorsOfZeroCannotBePlotted) {
  const Scratch scratch;
  const std::string command = "stress robots/pendulum_motor.toml --variants double -o " + scratch.path() + kFew;
  const Outcome outcome = run_flatdyn(command + " --functions inertia_matrix,jacobian");
  EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("no error above zero in double: nothing to plot\n"));
  EXPECT_THAT(scratch.read("stress.svg"), HasSubstr("nothing to plot: no error above zero"));
  EXPECT_THAT(scratch.read("stress.svg"), Not(HasSubstr("float")));
  const Outcome all = run_flatdyn(command);
  EXPECT_EQ(all.code, 0) << all.out << all.err;
  EXPECT_THAT(all.out, Not(HasSubstr("nothing to plot")));
  EXPECT_THAT(scratch.read("stress.svg"), HasSubstr("inertia_matrix: nothing to plot"));
}

TEST(Stress, IsTheSameInEveryRun) {
  const std::string command = std::string("stress robots/planar_2r.toml --functions bias --json") + kShort;
  EXPECT_EQ(run_flatdyn(command).out, run_flatdyn(command).out);
}

TEST(Stress, EndsWithVerificationFailedAboveTheBound) {
  const std::string command = "stress robots/ur5.urdf --functions gravity --variants double";
  EXPECT_EQ(run_flatdyn(command + kShort + " --bound 1e-3").code, 5);
  const Outcome lost = run_flatdyn(command + kShort + " --ratio 1e-3");
  EXPECT_EQ(lost.code, 5);
  EXPECT_THAT(lost.out, HasSubstr("LOST"));
}

TEST(Stress, TakesFamiliesInsteadOfRobots) {
  const Scratch scratch;
  const Outcome outcome = run_flatdyn("stress --family chains --robots 2 --functions gravity --variants double -o " +
                                      scratch.path() + kShort);
  EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("4 joints"));
  EXPECT_THAT(scratch.read("family_chains.svg"), HasSubstr("gravity, reference"));
  EXPECT_EQ(nlohmann::json::parse(scratch.read("family_chains.json"))["rows"].size(), 2u);
}

TEST(Stress, RefusesWhatItDoesNotKnow) {
  EXPECT_EQ(run_flatdyn("stress").code, 2);
  EXPECT_EQ(run_flatdyn("stress robots/ur5.urdf --family chains").code, 2);
  const Outcome family = run_flatdyn("stress --family chain");
  EXPECT_EQ(family.code, 2);
  EXPECT_THAT(family.err, HasSubstr("chains"));
  EXPECT_THAT(run_flatdyn("stress robots/planar_2r.toml --functions gravity --variants duoble").err,
              HasSubstr("double"));
}

}  // namespace
}  // namespace flatdyn::testing
