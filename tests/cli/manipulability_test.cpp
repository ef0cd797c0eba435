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

constexpr const char* kFreeArm = "manipulability docs/examples/free_arm.toml --torque 20 --states ";
constexpr const char* kFreeArmColumns = "q_hinge,q_ball.qw,q_ball.qx,q_ball.qy,q_ball.qz,q_slide,q_thumb";
constexpr const char* kFreeArmPosition = "0.3,0.7,0.1,0.7,0.1,0.05,0.2";

// The base's quaternion, which turns it about x, tells gravity as well as gravity itself does.
TEST(ManipulabilityCommand, TakesFloatingBasesAndSphericalJoints) {
  const Scratch scratch;
  scratch.write("gravity.csv",
                fmt::format("{},base_gx,base_gy,base_gz\n{},0,-9.81,0\n", kFreeArmColumns, kFreeArmPosition));
  scratch.write("pose.csv",
                fmt::format("{},base_qw,base_qx,base_qy,base_qz\n{},0.6,0.8,0,0\n", kFreeArmColumns, kFreeArmPosition));
  const Outcome outcome = run_flatdyn(kFreeArm + fmt::format("{} -o {} --plot {}", scratch.path("gravity.csv"),
                                                             scratch.path("m.csv"), scratch.path("m.svg")));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("1     228.255  23.76, 11.83, 0.8119  0, -9.81, 0\n"));
  EXPECT_THAT(scratch.read("m.csv"), StartsWith("q1,q2,q3,q4,q5,q6,q7,base_gx,base_gy,base_gz,p_x,p_y,p_z,centre_x,"));
  EXPECT_THAT(scratch.read("m.svg"), HasSubstr("free_arm: dynamic manipulability, free base, 1 m is "));
  const Outcome again = run_flatdyn(kFreeArm + fmt::format("{} --json", scratch.path("m.csv")));
  EXPECT_EQ(json::parse(again.out)["poses"][0]["g_b"], (json{0, -9.81, 0}));
  const Outcome pose = run_flatdyn(kFreeArm + fmt::format("{} --json", scratch.path("pose.csv")));
  ASSERT_EQ(pose.code, 0) << pose.err;
  const json turned = json::parse(pose.out)["poses"][0], centre = turned["centre"];
  EXPECT_EQ(turned["lengths"], json::parse(again.out)["poses"][0]["lengths"]);
  EXPECT_NEAR(centre[1].get<double>(), -9.81 * 0.96, 1e-12);
  EXPECT_NEAR(centre[2].get<double>(), 9.81 * 0.28, 1e-12);
}

TEST(ManipulabilityCommand, AsksForGravityOfAFloatingBase) {
  const Scratch scratch;
  scratch.write("q.csv", fmt::format("{}\n{}\n", kFreeArmColumns, kFreeArmPosition));
  scratch.write("part.csv", fmt::format("{},base_gx,base_gz\n{},0,1\n", kFreeArmColumns, kFreeArmPosition));
  scratch.write("norm.csv",
                fmt::format("{},base_qw,base_qx,base_qy,base_qz\n{},2,0,0,0\n", kFreeArmColumns, kFreeArmPosition));
  const Outcome missing = run_flatdyn(kFreeArm + scratch.path("q.csv"));
  EXPECT_EQ(missing.code, 3);
  EXPECT_THAT(missing.err,
              HasSubstr("q.csv:1: error: base_gx, base_gy, base_gz are missing: gravity shifts the ellipsoids"));
  EXPECT_THAT(missing.err, HasSubstr("or give base_qw to base_qz, the base's unit quaternion; --gravity off leaves"));
  EXPECT_THAT(run_flatdyn(kFreeArm + scratch.path("part.csv")).err, HasSubstr("part.csv:1: error: base_gy is missing"));
  EXPECT_THAT(run_flatdyn(kFreeArm + scratch.path("norm.csv")).err,
              HasSubstr("norm.csv:2: warning: the quaternion of the floating base has norm 2"));
  scratch.write("standing.toml", "[[contact]]\nlink = \"hand\"\n");
  const Outcome weightless =
      run_flatdyn(kFreeArm + scratch.path("q.csv") + " --gravity off --scene " + scratch.path("standing.toml"));
  EXPECT_THAT(weightless.err, HasSubstr("standing.toml: note: contacts have no effect here"));
  EXPECT_EQ(weightless.code, 0) << weightless.err;
  EXPECT_THAT(weightless.out, HasSubstr("23.76, 11.83, 0.8119  0, 0, 0\n"));
}

// Seen from its base, a free arm gets to the places that it gets to on a fixed one, with other ellipsoids.
TEST(ManipulabilityCommand, MapsTheWorkspaceOfAFreeBase) {
  const Scratch scratch;
  scratch.write("start.csv", "q1,q2,q3,q4,q5,q6,q7\n0,-0.3,0,-2.2,0,2,0.8\n");
  const auto map = [&](const std::string& base) {
    const Outcome outcome =
        run_flatdyn("manipulability robots/panda.urdf --gravity off --map xz --spacing 0.1 -q --json --base " + base +
                    " --states " + scratch.path("start.csv"));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return json::parse(outcome.out)["poses"];
  };
  const json fixed = map("fixed"), floating = map("floating");
  ASSERT_GT(fixed.size(), 50U);
  ASSERT_EQ(fixed.size(), floating.size());
  for (std::size_t k = 0; k < fixed.size(); ++k) {
    EXPECT_EQ(fixed[k]["q"], floating[k]["q"]);
    EXPECT_NE(fixed[k]["measure"], floating[k]["measure"]);
  }
}

TEST(ManipulabilityCommand, TakesLimitsOfSphericalJoints) {
  const Scratch scratch;
  scratch.write("q.csv",
                "q_waist,q_shoulder,q_wrist.qw,q_wrist.qx,q_wrist.qy,q_wrist.qz,q_knuckle,q_slide\n"
                "0.2,0.4,0.7,0.1,0.7,0.1,0.3,0.02\n");
  const std::string command = "manipulability docs/examples/ball_wrist.toml --norm limits --states ";
  const Outcome without = run_flatdyn(command + scratch.path("q.csv"));
  EXPECT_EQ(without.code, 4);
  EXPECT_THAT(without.err, HasSubstr("joint \"waist\" has no effort limit"));
  const Outcome limited =
      run_flatdyn(command + scratch.path("q.csv") + " --scene docs/examples/ball_wrist_limits.toml");
  EXPECT_EQ(limited.code, 0) << limited.err;
  EXPECT_THAT(limited.out, HasSubstr("1     295492   218.9, 44.2, 30.54  "));
}

}  // namespace
}  // namespace flatdyn::testing
