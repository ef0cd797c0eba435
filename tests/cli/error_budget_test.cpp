// SPDX-License-Identifier: GPL-2.0-or-later
// --error-budget, and the scene's error_budget.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/program.hpp"

namespace flatdyn::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

int operations(const json& manifest) {
  const json& torques = manifest.at("functions").at(0);
  return torques.at("multiplications").get<int>() + torques.at("additions").get<int>();
}

json generated(const Scratch& scratch, const std::string& options) {
  const Outcome outcome = run_flatdyn("generate robots/panda.urdf -q --json --functions inverse_dynamics -o " +
                                      scratch.path() + " " + options);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return json::parse(outcome.out);
}

TEST(ErrorBudget, BuysOperationsAndSaysWhatWasGivenUp) {
  const Scratch scratch;
  const json whole = generated(scratch, ""), part = generated(scratch, "--error-budget 1%");
  EXPECT_LT(operations(part), operations(whole));
  EXPECT_FALSE(whole.contains("error_budget"));
  const json& budget = part.at("error_budget");
  EXPECT_GT(budget.at("left_out").size(), 3u);
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_LE(budget.at("bound").at(i).get<double>(), budget.at("budget").at(i).get<double>());
    EXPECT_LE(budget.at("largest_seen").at(i).get<double>(),
              budget.at("bound").at(i).get<double>() * (1 + 1e-9) + 1e-9);
  }
  const std::string header = scratch.read("panda.hpp");
  EXPECT_THAT(header, HasSubstr("Left out for an error budget, of the base parameters: "));
  EXPECT_THAT(header, HasSubstr("--error-budget 1%"));
}

TEST(ErrorBudget, OfASceneIsTheSameAndTheCommandLineGoesBeforeIt) {
  const Scratch scratch;
  scratch.write("scene.toml", "error_budget = \"5%\"\n");
  const std::string scene = "--scene " + scratch.path("scene.toml");
  const int of_scene = operations(generated(scratch, scene)),
            of_option = operations(generated(scratch, "--error-budget 5%"));
  EXPECT_EQ(of_scene, of_option);
  EXPECT_GT(operations(generated(scratch, scene + " --error-budget 0.01%")), of_scene);
}

TEST(ErrorBudget, IsVerified) {
  const Outcome outcome = run_flatdyn(
      "verify robots/panda.urdf -q --json --error-budget 1% --functions "
      "inverse_dynamics,inertia_matrix,coriolis_matrix");
  ASSERT_EQ(outcome.code, 0) << outcome.err << outcome.out;
  const json report = json::parse(outcome.out);
  EXPECT_TRUE(report.at("passed").get<bool>());
  EXPECT_EQ(report.at("exactly").size(), 3u);
}

TEST(ErrorBudget, WrongOnesHaveTheirExitCodes) {
  EXPECT_EQ(run_flatdyn("verify robots/panda.urdf --error-budget much").code, 2);
  const Outcome unlimited = run_flatdyn("verify robots/ur5.urdf -q --error-budget 1%");
  EXPECT_EQ(unlimited.code, 4);
  EXPECT_THAT(unlimited.err, HasSubstr("has no limit of acceleration"));
}

}  // namespace
}  // namespace flatdyn::testing
