// SPDX-License-Identifier: GPL-2.0-or-later
// Steps in time on the command line: each by itself in every language, in scenes, in tables, and what is refused.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/program.hpp"

namespace flatdyn::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kTwoLinks = "robots/planar_2r_example_7_2.toml";

// A function all of whose sines are those of computed angles needs the same helpers as others.
TEST(StepFunctions, AreThereByThemselvesInEveryLanguage) {
  const Scratch folder;
  for (const char* language : {"c++", "c++ --form pair", "c++ --max-lines 30", "c", "cuda", "javascript", "rust"}) {
    for (const char* function : {"step:rk4", "step:implicit_midpoint"}) {
      const Outcome outcome = run_flatdyn(fmt::format("generate {} --language {} --functions {} -o '{}'", kTwoLinks,
                                                      language, function, folder.path()));
      EXPECT_EQ(outcome.code, 0) << language << ", " << function << ": " << outcome.err;
    }
  }
}

// The base's displacement and turn are outputs, and velocities are v in every name.
TEST(StepFunctions, MoveAFloatingBaseInEveryLanguage) {
  const Scratch folder;
  for (const char* language : {"c++", "c++ --form pair", "c", "cuda", "javascript", "rust"}) {
    const Outcome outcome =
        run_flatdyn(fmt::format("generate docs/examples/floating_body.toml --language {} --functions "
                                "step:rk4,step:implicit_midpoint,step_derivatives:semi_implicit_euler -o '{}'",
                                language, folder.path()));
    EXPECT_EQ(outcome.code, 0) << language << ": " << outcome.err;
  }
  const std::string header = folder.read("body.h");
  EXPECT_THAT(header, HasSubstr("const double v_end[6]"));
  EXPECT_THAT(header, HasSubstr("double displacement[3], double turn[4], double residual[6]"));
}

TEST(StepFunctions, TakeQuaternionsFromATable) {
  const Scratch folder;
  folder.write("states.csv", "q1,q2,q3,q4,qd1,qd2,qd3,tau1,tau2,tau3,h\n0.8,0,0.6,0,1,2,3,0,0,0,0\n");
  const Outcome still = run_flatdyn(fmt::format(
      "eval docs/examples/spherical_pendulum.toml --states '{}' --function step:rk4", folder.path("states.csv")));
  EXPECT_EQ(still.code, 0) << still.err;
  EXPECT_THAT(still.out, HasSubstr("0.8,0,0.6,0,1,2,3"));
}

TEST(StepFunctions, AreMadeInFullWhereTheSceneIsAtRest) {
  const Scratch folder;
  folder.write("still.toml", "static = true\n");
  const Outcome outcome =
      run_flatdyn(fmt::format("generate {} --scene '{}' --functions step:rk4 --language c -v -o '{}'", kTwoLinks,
                              folder.path("still.toml"), folder.path()));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out + outcome.err, HasSubstr("step:rk4 is made in full"));
  EXPECT_THAT(folder.read("planar_2r_example_7_2.c"), HasSubstr("qd[1]"));
}

TEST(StepFunctions, ReadTheStepLengthFromATable) {
  const Scratch folder;
  folder.write("states.csv", "q1,q2,qd1,qd2,tau1,tau2,h\n0.1,0.2,0.3,0.4,1,2,0\n");
  const std::string command = fmt::format("eval {} --states '{}' --function ", kTwoLinks, folder.path("states.csv"));
  const Outcome still = run_flatdyn(command + "step:rk4");
  EXPECT_EQ(still.code, 0) << still.err;
  EXPECT_THAT(still.out, HasSubstr("0.1,0.2,0.3,0.4"));  // a step of length 0 changes nothing
  const Outcome missing = run_flatdyn(command + "step:implicit_midpoint");
  EXPECT_THAT(missing.err, HasSubstr("qd_end1"));
  EXPECT_THAT(missing.err, Not(HasSubstr(" h ")));
}

TEST(StepFunctions, SayWhatIsRefused) {
  const Scratch folder;
  const auto generated = [&folder](const std::string& what) {
    return run_flatdyn(fmt::format("generate {} -o '{}'", what, folder.path()));
  };
  const Outcome loops = generated("robots/four_bar.toml --functions step:rk4");
  EXPECT_THAT(loops.err, HasSubstr("loop_step"));
  const Outcome unknown = generated(fmt::format("{} --functions step:euler", kTwoLinks));
  EXPECT_THAT(unknown.err, HasSubstr("step:semi_implicit_euler"));
  EXPECT_THAT(unknown.err, Not(HasSubstr("inverse_dynamics")));
  EXPECT_TRUE(folder.is_empty());
}

}  // namespace
}  // namespace flatdyn::testing
