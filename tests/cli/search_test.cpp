// SPDX-License-Identifier: GPL-2.0-or-later
// --search as a user sees it.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/program.hpp"

namespace flatdyn::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

constexpr const char* kGenerate = "generate robots/planar_2r.toml --functions inverse_dynamics,gravity -o ";

TEST(Search, WhatIsNoLimitIsUsageWithAHint) {
  const Scratch scratch;
  for (const char* limit : {"0", "-5", "1.5", "soon", "10m", "0s"}) {
    const Outcome outcome = run_flatdyn(kGenerate + scratch.path("out") + " --search=" + limit);
    EXPECT_EQ(outcome.code, 2) << limit;
    EXPECT_THAT(outcome.err, HasSubstr("write a number of candidates, such as 200, or a time, such as 30s")) << limit;
  }
  EXPECT_TRUE(scratch.is_empty());
  EXPECT_EQ(run_flatdyn("bench --growth --search 5").code, 2);
}

TEST(Search, WhatWasChosenIsInTheManifestAndHowFarItWentInTheStamp) {
  const Scratch scratch;
  const Outcome outcome = run_flatdyn(kGenerate + scratch.path("out") + " --search 12");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("before search"));
  const json manifest = json::parse(scratch.read("out/planar_2r.json"));
  EXPECT_THAT(manifest.at("options").get<std::string>(), HasSubstr("--search 12"));
  EXPECT_THAT(scratch.read("out/planar_2r.hpp"), HasSubstr("--search 12"));
  for (const json& function : manifest.at("functions")) {
    const json& search = function.at("search");
    EXPECT_EQ(search.at("candidates"), 12);
    const int after = function.at("multiplications").get<int>() + function.at("additions").get<int>();
    EXPECT_LE(after,
              search.at("before").at("multiplications").get<int>() + search.at("before").at("additions").get<int>());
  }
}

TEST(Search, ATimeSaysHowManyCandidatesMakeTheSameAgain) {
  const Scratch scratch;
  const Outcome timed = run_flatdyn(kGenerate + scratch.path("timed") + " --search 0.2s");
  ASSERT_EQ(timed.code, 0) << timed.err;
  const json manifest = json::parse(scratch.read("timed/planar_2r.json"));
  const int candidates = manifest.at("functions").at(0).at("search").at("candidates");
  EXPECT_THAT(timed.err, HasSubstr(fmt::format("--search {} makes the same again", candidates)));
  if (candidates == 0) GTEST_SKIP() << "a machine too slow for one candidate";
  ASSERT_EQ(run_flatdyn(kGenerate + scratch.path("counted") + fmt::format(" --search {}", candidates)).code, 0);
  EXPECT_EQ(scratch.read("timed/planar_2r.hpp"), scratch.read("counted/planar_2r.hpp"));
}

TEST(Search, VerifyProvesWhatItFinds) {
  const Outcome outcome = run_flatdyn("verify robots/ur5.urdf --functions inverse_dynamics --states 20 --search 20");
  EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
}

}  // namespace
}  // namespace flatdyn::testing
