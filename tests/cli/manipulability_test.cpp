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
using ::testing::Not;
using ::testing::StartsWith;

constexpr const char* kManipulability = "manipulability robots/planar_2r_example_7_2.toml --states ";

TEST(ManipulabilityCommand, WritesTableAndPicture) {
  const Scratch scratch;
  const Outcome outcome =
      run_flatdyn(kManipulability + fmt::format("docs/examples/two_poses.csv --torque 500 -o {} --plot {}",
                                                scratch.path("m.csv"), scratch.path("m.svg")));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, StartsWith("pose  measure  half axes     centre x, y\n1     7.95611  4.411, 1.804  "));
  EXPECT_THAT(scratch.read("m.csv"),
              StartsWith("q1,q2,p_x,p_y,p_z,centre_x,centre_y,length_1,length_2,axis_1_x,axis_1_y,axis_2_x,"
                         "axis_2_y,measure\n0.5,1,0.9483"));
  EXPECT_THAT(scratch.read("m.svg"), HasSubstr("accelerations at the tip: 1 m is "));
}

TEST(ManipulabilityCommand, PrintsJson) {
  const Outcome outcome = run_flatdyn(kManipulability + std::string("docs/examples/two_poses.csv --json"));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json document = json::parse(outcome.out);
  EXPECT_EQ(document["task"], (json{"x", "y"}));
  ASSERT_EQ(document["poses"].size(), 2U);
  EXPECT_EQ(document["poses"][1]["q"], (json{1.5, -1.2}));
}

// A redundant arm makes larger accelerations where all torques count.
TEST(ManipulabilityCommand, CountsAllTorquesOnRequest) {
  const auto measure = [](const std::string& norm) {
    const Outcome outcome = run_flatdyn(
        "manipulability robots/panda.urdf --states docs/examples/panda_states.csv -q --json --norm " + norm);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const json document = json::parse(outcome.out);
    EXPECT_EQ(document["norm"], norm);
    return document["poses"][0]["measure"].get<double>();
  };
  EXPECT_GT(measure("torque"), 1.01 * measure("plain"));
  EXPECT_GT(measure("torque-limits"), 1.01 * measure("limits"));
}

// For a spatial arm there are four views, side by side; along a path also curves of the half axes.
TEST(ManipulabilityCommand, DrawsViewsAndPaths) {
  const Scratch scratch;
  std::string path = "t,q1,q2,q3,q4,q5,q6\n";
  for (int k = 0; k < 30; ++k) path += fmt::format("{},{},-1.2,1.5,-0.3,1.57,0\n", 0.1 * k, 0.05 * k);
  scratch.write("path.csv", path);
  const auto drawn = [&](const std::string& options) {
    const Outcome outcome =
        run_flatdyn(fmt::format("manipulability robots/ur5.urdf --states {} --plot {} -o {} {}",
                                scratch.path("path.csv"), scratch.path("p.svg"), scratch.path("p.csv"), options));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("... and 10 more\nthe measure is from "));
    return scratch.read("p.svg");
  };
  const std::string all = drawn("");
  for (const char* text : {">xz<", ">yz<", ">xy<", ">space<", ">half axes<", ">t in s<"}) {
    EXPECT_THAT(all, HasSubstr(text));
  }
  EXPECT_THAT(scratch.read("p.csv"), StartsWith("t,q1,q2,q3,q4,q5,q6,p_x,p_y,p_z,centre_x,"));
  const std::string one = drawn("--view space");
  EXPECT_THAT(one, HasSubstr("accelerations at the tip: 1 m is "));
  EXPECT_THAT(one, Not(HasSubstr(">xz<")));
}

TEST(ManipulabilityCommand, MapsTheWorkspace) {
  const Scratch scratch;
  scratch.write("start.csv", "q1,q2\n0.5,1\n");
  const Outcome outcome = run_flatdyn(kManipulability + fmt::format("{} --map xy --spacing 0.2 --json -o {} --plot {}",
                                                                    scratch.path("start.csv"), scratch.path("m.csv"),
                                                                    scratch.path("m.svg")));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json document = json::parse(outcome.out);
  EXPECT_NEAR(static_cast<double>(document["poses"].size()) * 0.04, 4 * 3.14159, 0.7);  // links of 1 m: a disk of 2 m
  EXPECT_EQ(document["poses"][0]["q"], (json{0.5, 1}));
  EXPECT_THAT(scratch.read("m.svg"), HasSubstr("ellipsoids about places of the tip"));
}

TEST(ManipulabilityCommand, DiagnosesWrongMaps) {
  const Scratch scratch;
  scratch.write("two.csv", "q1,q2\n0,1\n\n0,2\n");
  scratch.write("beyond.csv", "# a comment\nq1,q2,q3,q4,q5,q6,q7\n0,0,0,0.5,0,1,0\n");
  const auto run = [&](const std::string& arguments) {
    return run_flatdyn("manipulability " + arguments + " --states " + scratch.path("two.csv"));
  };
  const Outcome two = run("robots/planar_2r_example_7_2.toml --map xy");
  EXPECT_EQ(two.code, 3);
  EXPECT_THAT(two.err, HasSubstr("two.csv:4: error: a map starts at one position"));
  const Outcome beyond =
      run_flatdyn("manipulability robots/panda.urdf --map xz --states " + scratch.path("beyond.csv"));
  EXPECT_EQ(beyond.code, 3);
  EXPECT_THAT(beyond.err, HasSubstr("beyond.csv:3: error: the map's start is beyond the joints' limits"));
  EXPECT_EQ(run("robots/planar_2r_example_7_2.toml --spacing 0.1").code, 2);
  EXPECT_EQ(run("robots/planar_2r_example_7_2.toml --map xy --view xy").code, 2);
}

TEST(ManipulabilityCommand, DiagnosesBadInput) {
  const Scratch scratch;
  scratch.write("empty.csv", "q1,q2\n");
  scratch.write("columns.csv", "q1,q\n0,0\n");
  scratch.write("infinite.csv", "q1,q2\n0,1\n0,nan\n");
  const auto run = [&](const char* file) { return run_flatdyn(kManipulability + scratch.path(file)); };
  for (const auto& [file, message] : {std::pair{"empty.csv", "empty.csv: error: there is no row"},
                                      std::pair{"columns.csv", "columns.csv:1: error: no column for the positions: q2"},
                                      std::pair{"infinite.csv", "infinite.csv:3: error: column \"q2\": \"nan\""}}) {
    const Outcome outcome = run(file);
    EXPECT_EQ(outcome.code, 3) << file;
    EXPECT_THAT(outcome.err, HasSubstr(message));
  }
  EXPECT_EQ(run("missing.csv").code, 6);
  const Outcome limits = run_flatdyn(kManipulability + std::string("docs/examples/two_poses.csv --norm limits"));
  EXPECT_EQ(limits.code, 4);
  EXPECT_THAT(limits.err, HasSubstr("joint \"theta_1\" has no effort limit"));
}

}  // namespace
}  // namespace flatdyn::testing
