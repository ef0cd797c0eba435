// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/program.hpp"

namespace flatdyn::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr const char* kArm = "manipulability robots/planar_2r_example_7_2.toml -q --states ";

TEST(ManipulabilityCommand, WritesTableAndPicture) {
  const Scratch scratch;
  const Outcome outcome = run_flatdyn(kArm + fmt::format("docs/examples/two_poses.csv --torque 500 -o {} --plot {}",
                                                         scratch.path("m.csv"), scratch.path("m.svg")));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, StartsWith("pose  measure  half axes     centre x, y\n1     7.95611  4.411, 1.804  "));
  EXPECT_THAT(scratch.read("m.csv"), StartsWith("q1,q2,centre_x,centre_y,length_1,length_2,axis_1_x,axis_1_y,axis_2_x,"
                                                "axis_2_y,measure\n0.5,1,3.958"));
  EXPECT_THAT(scratch.read("m.svg"), HasSubstr("accelerations at the tip: 1 m is "));
}

TEST(ManipulabilityCommand, PrintsJson) {
  const Outcome outcome = run_flatdyn(kArm + std::string("docs/examples/two_poses.csv --json"));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json document = json::parse(outcome.out);
  EXPECT_EQ(document["task"], (json{"x", "y"}));
  ASSERT_EQ(document["poses"].size(), 2U);
  EXPECT_EQ(document["poses"][1]["q"], (json{1.5, -1.2}));
}

TEST(ManipulabilityCommand, DiagnosesBadInput) {
  const Scratch scratch;
  scratch.write("empty.csv", "q1,q2\n");
  scratch.write("columns.csv", "q1,q\n0,0\n");
  scratch.write("infinite.csv", "q1,q2\n0,1\n0,nan\n");
  const auto run = [&](const char* file) { return run_flatdyn(kArm + scratch.path(file)); };
  for (const auto& [file, message] :
       {std::pair{"empty.csv", "empty.csv: error: there is no row"},
        std::pair{"columns.csv", "columns.csv:1: error: there is no column q2 or q_theta_2"},
        std::pair{"infinite.csv", "infinite.csv:3: error: column \"q2\": \"nan\""}}) {
    const Outcome outcome = run(file);
    EXPECT_EQ(outcome.code, 3) << file;
    EXPECT_THAT(outcome.err, HasSubstr(message));
  }
  EXPECT_EQ(run("missing.csv").code, 6);
  const Outcome limits = run_flatdyn(kArm + std::string("docs/examples/two_poses.csv --norm limits"));
  EXPECT_EQ(limits.code, 4);
  EXPECT_THAT(limits.err, HasSubstr("joint \"theta_1\" has no effort limit"));
}

}  // namespace
}  // namespace flatdyn::testing
